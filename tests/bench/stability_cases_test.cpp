// Runs every stability case in its short form: it passes, and each of its mutations makes it fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bench/experiments/stability/verdict.h"
#include "tests/support/statistics.h"

namespace {

using namespace bench::stability;

class StabilityCases : public testing::TestWithParam<const StabilityCase*> {};

TEST_P(StabilityCases, AreAsPredicted) {
    // In slow builds there are too few seeds to judge by: there, the sanitizers only check the code.
    const bool judged = tests::count_for(1, 0) == 1;
    const auto curves = GetParam()->run(CaseRun(false, {}, {}, judged ? 12 : 2));
    ASSERT_FALSE(curves.empty());
    if (!judged) return;
    const std::size_t cases = stability_cases().size();
    const double false_alarms = false_alarms_per_point(curves, cases);
    for (const StabilityCurve& curve : curves)
        for (const StabilityPoint& point : curve.points) {
            const PointVerdict verdict = judge(point, curve.expected, false_alarms);
            EXPECT_TRUE(verdict.passed) << curve.name << " at " << point.at << ": " << verdict.mean
                                        << ", not " << point.predicted << " +- " << verdict.band;
        }
    EXPECT_TRUE(passes(curves, cases));
}

TEST_P(StabilityCases, CanFail) {
    EXPECT_FALSE(GetParam()->mutations.empty());
    if (tests::count_for(0, 1) == 1) GTEST_SKIP() << "the optimised build shows it";
    for (const std::string& mutation : GetParam()->mutations)
        EXPECT_FALSE(passes(GetParam()->run(CaseRun(false, mutation)), stability_cases().size())) << mutation;
}

TEST_P(StabilityCases, SayWhatTheyAre) {
    const StabilityCase& one = *GetParam();
    for (const std::string* text :
         {&one.name, &one.purpose, &one.scene, &one.swept, &one.measured, &one.theory, &one.advice})
        EXPECT_FALSE(text->empty()) << one.name;
    EXPECT_TRUE(std::all_of(one.name.begin(), one.name.end(), [](char c) {
        return std::islower(c) || std::isdigit(c) || c == '-';
    })) << one.name;
}

INSTANTIATE_TEST_SUITE_P(Cases, StabilityCases, testing::ValuesIn(stability_cases()), [](const auto& given) {
    std::string name = given.param->name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(StabilityVerdict, KnowsItsBands) {
    const StabilityPoint random{0, 1.0, 0.1, {0.9, 1.0, 1.1, 1.0}};
    const PointVerdict verdict = judge(random, Expected::equal, 0.01);
    EXPECT_NEAR(verdict.mean, 1, 1e-12);
    // The standard error is sqrt(0.02 / 3 / 4) = 0.0408248. Student's t with 3 degrees of freedom is 5.8409
    // at 1 %, 3.1824 at 5 %.
    EXPECT_NEAR(verdict.band, 0.1 + 5.8409 * 0.0408248, 1e-4);
    EXPECT_NEAR(verdict.confidence, 3.1824 * 0.0408248, 1e-4);
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    for (const auto expected : {Expected::equal, Expected::at_most}) {
        EXPECT_FALSE(judge({0, 1, 9, {not_a_number}}, expected, 0.01).passed);
        EXPECT_FALSE(judge({0, 1, 9, {}}, expected, 0.01).passed) << "nothing was measured";
        EXPECT_FALSE(judge({0, 1, 0.1, {1.2}}, expected, 0.01).passed);
        EXPECT_TRUE(judge({0, 1, 0.3, {1.2}}, expected, 0.01).passed);
    }
    EXPECT_TRUE(judge({0, 1, 0, {0.5}}, Expected::at_most, 0.01).passed);
    EXPECT_FALSE(passes({}, 1)) << "a case that judges nothing";
}

}  // namespace
