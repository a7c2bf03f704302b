// The number of threads that parallel work uses.
#pragma once

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <utility>

namespace common {

/// Executes work in which oneTBB's parallel algorithms use exactly `threads` threads, even more than the
/// machine has cores. Only one ThreadPool may live at a time.
class ThreadPool {
  public:
    explicit ThreadPool(int threads)
        : limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
          arena_(threads) {}

    template <class Work>
    decltype(auto) run(Work&& work) {
        return arena_.execute(std::forward<Work>(work));
    }

    [[nodiscard]] int threads() const { return arena_.max_concurrency(); }

  private:
    tbb::global_control limit_;
    tbb::task_arena arena_;
};

}  // namespace common
