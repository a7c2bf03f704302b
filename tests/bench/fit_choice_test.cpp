// Tests the choice for known errors and costs, and the reason where no choice is possible.
#include <gtest/gtest.h>

#include <set>

#include "bench/experiments/fit/choice.h"

namespace {

using namespace bench;
using namespace bench::fit;

/// Two light maps and two photon maps of known errors and costs, from a pilot of a million hits.
class FitChoice : public testing::Test {
  protected:
    std::vector<Candidate> candidates = {{CandidateKind::light_map, "L2/radiance", "own", 1024},
                                         {CandidateKind::light_map, "L2/radiance", "own", 4096},
                                         {CandidateKind::photon_radius, "disc", "r", 0.01},
                                         {CandidateKind::photon_share, "disc", "k", 1e-6}};
    Estimates estimates;
    std::vector<std::optional<PilotCost>> costs;
    ContenderSettings settings;
    FitGoal goal{.target = 0.05, .z = 0, .max_hits = 1e9};

    FitChoice() {
        // For 0.05^2 = 0.0025 they need 1.25e6, 4e6, 1.6e7 and 4e6 hits (k = 8 needs twice as many).
        add({.pilot_hits = 1e6, .noise_sq = 0.00125, .blur_sq = 0.0015}, 1, 1e5);
        add({.pilot_hits = 1e6, .noise_sq = 0.008, .blur_sq = 0.0005}, 1.5, 4e5);
        add({.pilot_hits = 1e6, .noise_sq = 0.032, .blur_sq = 0.0005}, 2, 23e6);
        add({.pilot_hits = 1e6, .noise_sq = 0.01}, 3, 23e6);
    }

    void add(const ErrorModel& model, double seconds, double bytes) {
        estimates.model.emplace_back(model);
        estimates.measured.push_back(true);
        costs.push_back(PilotCost{.hits = 1e6, .trace_seconds = seconds, .bytes = bytes});
    }

    [[nodiscard]] Choice chosen(bool light_maps, std::size_t max_bytes = std::size_t{1} << 40) const {
        const std::vector<NeededHits> needed = needed_by_error(estimates, goal);
        return choose({candidates, estimates, needed, costs, settings, max_bytes}, goal, light_maps);
    }
    [[nodiscard]] std::string doubts_of(const Choice& choice, const std::string& lost_light = "") const {
        const std::vector<NeededHits> needed = needed_by_error(estimates, goal);
        return doubts({candidates, estimates, needed, costs, settings, std::size_t{1} << 40}, goal, choice,
                      lost_light);
    }
    [[nodiscard]] Choice light_map() const { return chosen(true); }
    [[nodiscard]] Choice photon_map() const { return chosen(false); }
};

TEST_F(FitChoice, TakesTheLeastTime) {
    const Choice choice = light_map();
    ASSERT_TRUE(choice.reached) << choice.reason;
    EXPECT_EQ(choice.proposal.candidate, 0u);
    EXPECT_NEAR(choice.proposal.hits, 1.25e6, 2);
    EXPECT_NEAR(choice.proposal.cost.seconds, 1.25, 1e-5);
    EXPECT_EQ(choice.proposal.cost.bytes, 1e5) << "a light map's do not grow";
    EXPECT_EQ(choice.reason, "");
}

TEST_F(FitChoice, IsUnsureWhereChanceMayHaveMadeIt) {
    EXPECT_EQ(doubts_of(light_map()), "");
    goal.z = 1.3;
    for (auto& model : estimates.model) model->bias_variance = 4e-4 * 4e-4;  // 0.21 of the target's square
    const Choice choice = light_map();
    ASSERT_TRUE(choice.reached) << choice.reason;
    EXPECT_NE(doubts_of(choice).find("chance"), std::string::npos);
    goal.target = 0.01;
    EXPECT_EQ(doubts_of(light_map()), "") << "that it is out of reach is another matter";
}

TEST_F(FitChoice, IsUnsureOfWhatWasNotMeasured) {
    estimates.measured[0] = false;
    EXPECT_NE(doubts_of(light_map()).find("coarser"), std::string::npos);
    EXPECT_EQ(doubts_of(photon_map()), "");
}

TEST_F(FitChoice, IsUnsureOfLightThatNoPathFinds) {
    EXPECT_NE(doubts_of(photon_map(), "light of 1 point lights").find("light of 1 point lights"),
              std::string::npos);
}

TEST_F(FitChoice, PhotonMapsGrowAndSharesTakeEightPhotons) {
    ASSERT_TRUE(photon_map().reached);
    const Proposal chosen = photon_map().proposal;
    EXPECT_EQ(chosen.candidate, 3u);
    EXPECT_NEAR(chosen.hits, 8e6, 2);
    EXPECT_NEAR(chosen.cost.bytes, 8 * 23e6, 100);
    EXPECT_EQ(candidates[3].name(8'000'000), "photonmap/compact/k8/disc");
}

TEST_F(FitChoice, TakesTheFewestBytes) {
    goal.least_bytes = true;
    goal.target = 0.03;  // squared 0.0009: the first light map blurs too much
    EXPECT_EQ(light_map().proposal.candidate, 1u);
    goal.target = 0.05;
    EXPECT_EQ(photon_map().proposal.candidate, 3u);
}

TEST_F(FitChoice, EqualBytesTakeTheFewestHitsHoweverFastEachWas) {
    goal.least_bytes = true;
    costs[1]->bytes = costs[0]->bytes;
    for (const double seconds : {0.1, 10.0}) {
        costs[1]->trace_seconds = seconds;
        EXPECT_EQ(light_map().proposal.candidate, 0u) << seconds;
    }
}

TEST_F(FitChoice, KeepsWithinBudgets) {
    goal.budget_seconds = 30;
    ASSERT_TRUE(photon_map().reached);
    goal.budget_seconds = 20;
    EXPECT_FALSE(photon_map().reached);
    EXPECT_NE(photon_map().reason.find("--budget-time is 20 s"), std::string::npos) << photon_map().reason;
    goal.budget_bytes = 50e6;
    goal.budget_seconds = 1e9;
    EXPECT_TRUE(light_map().reached);
    EXPECT_NE(photon_map().reason.find("--budget-bytes is 5e+07"), std::string::npos) << photon_map().reason;
}

TEST_F(FitChoice, SaysHowManyHitsItWouldTake) {
    goal.max_hits = 1e6;
    EXPECT_FALSE(light_map().reached);
    EXPECT_NE(
        light_map().reason.find("shlm/L2/radiance/own/t1024/h0/half takes 1.25e+06 hits, and --max-hits is "
                                "1e+06"),
        std::string::npos)
        << light_map().reason;
}

TEST_F(FitChoice, TakesTheNextBestWhereTheBestIsBeyondABudget) {
    goal.least_bytes = true;
    goal.budget_seconds = 20;  // excludes the share of 24 s and the radius of 32 s
    EXPECT_FALSE(photon_map().reached);
    goal.budget_bytes = 2e5;
    goal.budget_seconds = 1e9;
    EXPECT_EQ(light_map().proposal.candidate, 0u);
}

TEST_F(FitChoice, SaysWhichBiasForbidsTheTarget) {
    goal.target = 0.02;
    const Choice choice = light_map();
    EXPECT_FALSE(choice.reached);
    EXPECT_EQ(choice.proposal.candidate, 1u) << "comes nearest";
    EXPECT_NE(choice.reason.find(
                  "2 % is below the bias of shlm/L2/radiance/own/t4096/h0/half, 2.24 % (blur 2.24 %, "
                  "truncation 0 %)"),
              std::string::npos)
        << choice.reason;
    EXPECT_NE(choice.reason.find("no setting of the grid reaches it"), std::string::npos);
    EXPECT_TRUE(photon_map().reached) << "the share has no blur";
}

TEST_F(FitChoice, SaysWhenItCannotTell) {
    goal.target = 0.03;
    goal.z = 1;
    estimates.model[0]->bias_variance = estimates.model[1]->bias_variance = 1e-6;  // 0.001 beside 0.0005
    const Choice choice = light_map();
    EXPECT_FALSE(choice.reached);
    EXPECT_NE(choice.reason.find("a larger --pilot"), std::string::npos) << choice.reason;
}

TEST_F(FitChoice, SaysWhenNothingWasMeasured) {
    estimates.model.assign(4, std::nullopt);
    EXPECT_EQ(light_map().reason, "no light map of the grid could be measured");
    EXPECT_EQ(photon_map().reason, "no photon map of the grid could be measured");
}

TEST_F(FitChoice, LeavesOutWhatTheMemoryDoesNotHold) {
    constexpr std::size_t little = 100'000'000;
    EXPECT_FALSE(chosen(false, little).reached);
    EXPECT_TRUE(chosen(true, little).reached);
}

TEST_F(FitChoice, AnAdaptiveMapTakesThePilotsHits) {
    candidates[0] = {CandidateKind::adaptive_map, "adaptive", "bilinear", 4, 262144};
    estimates.model[0]->at_pilot_alone = true;  // an error of 0.0525 at a million hits
    EXPECT_EQ(light_map().proposal.candidate, 1u) << "which reaches 0.05";
    goal.target = 0.06;
    EXPECT_EQ(light_map().proposal.candidate, 0u);
    EXPECT_EQ(light_map().proposal.hits, 1e6);
    goal.target = 0.02;
    EXPECT_EQ(light_map().proposal.candidate, 1u)
        << "what an adaptive map shows now is no bound of what it can";
}

TEST(NeededHits, AreMoreTheSurerOneMustBe) {
    Estimates estimates;
    estimates.model = {ErrorModel{.pilot_hits = 1e6,
                                  .noise_sq = 0.002,
                                  .blur_sq = 0.001,
                                  .bias_variance = 1e-8,
                                  .spread_variance = 1e-8},
                       std::nullopt};
    estimates.measured = {true, false};
    const auto needed = needed_by_error(estimates, {.target = 0.05, .z = 1});
    EXPECT_LT(needed[0].least.value(), needed[0].likely.value());
    EXPECT_LT(needed[0].likely.value(), needed[0].sure.value());
    EXPECT_LT(needed[0].expected.value(), 0.05);
    EXPECT_FALSE(needed[1].least) << "nothing is known";
}

TEST(NeededHits, OfWhatIsTriedAgainAndAgainMustPassMoreSurely) {
    Estimates estimates;
    const ErrorModel model{.pilot_hits = 1e6, .noise_sq = 0.001, .blur_sq = 0.001, .bias_variance = 4e-8};
    ErrorModel tried = model;
    tried.at_pilot_alone = true;
    estimates.model = {model, tried};
    estimates.measured = {true, true};
    // 0.002 plus two standard errors of 0.0002 is below 0.05 squared, but not 0.002 plus three.
    EXPECT_TRUE(needed_by_error(estimates, {.target = 0.05, .z = 3, .z_of_tries = 2})[1].sure);
    const auto needed = needed_by_error(estimates, {.target = 0.05, .z = 2, .z_of_tries = 3});
    EXPECT_TRUE(needed[0].sure);
    EXPECT_FALSE(needed[1].sure);
}

// The list of candidates.

TEST(FitCandidates, HaveNamesThatAreReadAndStayTheSame) {
    for (const Candidate& candidate : all_candidates()) {
        const std::string name = candidate.name(4'000'000);
        EXPECT_EQ(parse_contender("test", name).name, name);
    }
    for (const std::string& name : grid_names()) EXPECT_EQ(parse_contender("test", name).name, name);
    EXPECT_EQ(parse_contenders("test", grid_names()).size(), grid_names().size()) << "each once";
}

TEST(FitCandidates, GoFromCoarseToFineInEachChain) {
    const std::vector<Candidate> all = all_candidates();
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i].chain() == all[i - 1].chain()) {
            EXPECT_LT(all[i].width(), all[i - 1].width()) << all[i].name(1'000'000);
        }
}

TEST(FitCandidates, AdaptiveMapsAreAloneInTheirChains) {
    std::set<std::string> chains;
    for (const Candidate& candidate : all_candidates())
        if (candidate.is_adaptive()) {
            EXPECT_TRUE(chains.insert(candidate.chain()).second)
                << "a law would be carried on: " << candidate.chain();
        }
    EXPECT_GT(chains.size(), 10u);
}

TEST(FitCosts, TakeTheTimePerHitOfTheLargestPilotForTracing) {
    const std::vector<Candidate> candidates = {{CandidateKind::light_map, "L0/normalised", "own", 1024},
                                               {CandidateKind::photon_radius, "disc", "r", 0.01}};
    std::vector<PilotSample> samples(2);
    for (PilotSample& sample : samples) sample.halves.a = sample.halves.b = {common::Rgb(1)};
    samples[0].cost = {.hits = 1e4, .trace_seconds = 0.02, .insert_seconds = 0.001};  // settled early
    samples[1].cost = {.hits = 1e6, .trace_seconds = 1, .insert_seconds = 0.3};
    const auto costs = costs_of(candidates, samples);
    EXPECT_DOUBLE_EQ(costs[0]->trace_seconds, 0.01);
    EXPECT_EQ(costs[0]->insert_seconds, 0.001);
    EXPECT_EQ(costs[1]->trace_seconds, 1);
}

TEST(FitCosts, AreCarriedOnToLightMapsThatWereNotMeasured) {
    const std::vector<Candidate> candidates = {{CandidateKind::light_map, "L2/radiance", "own", 1024},
                                               {CandidateKind::light_map, "L2/radiance", "own", 4096},
                                               {CandidateKind::light_map, "L2/radiance", "surface4", 4096}};
    std::vector<PilotSample> samples(3);
    samples[0].halves.a = samples[0].halves.b = {common::Rgb(1)};
    samples[0].cost = {.hits = 1e6, .trace_seconds = 1, .build_seconds = 0.5, .bytes = 1000};
    const auto costs = costs_of(candidates, samples);
    ASSERT_TRUE(costs[1]);
    EXPECT_EQ(costs[1]->bytes, 4000);
    EXPECT_EQ(costs[1]->build_seconds, 2);
    EXPECT_EQ(costs[1]->trace_seconds, 1);
    EXPECT_FALSE(costs[2]) << "another chain";
}

}  // namespace
