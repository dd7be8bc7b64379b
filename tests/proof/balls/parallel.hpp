/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All processors, each of which takes the next one. */
#ifndef PARALLEL_HPP
#define PARALLEL_HPP

#include <atomic>
#include <thread>
#include <vector>

#include "balls/ball.hpp"

/* work(0) ... work(count - 1) */
template <typename Work> void in_parallel(size_t count, const Work &work)
{
    std::atomic<size_t> next(0);
    const auto take_part = [&] {
        for (size_t i; (i = next++) < count;)
            work(i);
        flint_cleanup();
    };
    std::vector<std::thread> threads;
    while (threads.size() + 1 < std::thread::hardware_concurrency())
        threads.emplace_back(take_part);
    take_part();
    for (std::thread &thread : threads)
        thread.join();
}

#endif
