// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace bench {

/// Calls work(0) to work(count - 1) once each on two threads, in any order; and progress(done) now and then on this
/// thread.
inline void inParallel(std::size_t count, const std::function<void(std::size_t)>& work,
                       const std::function<void(std::size_t)>& progress)
{
    std::atomic<std::size_t> next{0};
    const auto takeAll = [&](bool tells) {
        for (std::size_t k = next++; k < count; k = next++) {
            work(k);
            if (tells)
                progress(std::min(count, next.load()));
        }
    };
    std::thread other(takeAll, false);
    takeAll(true);
    other.join();
}

}  // namespace bench
