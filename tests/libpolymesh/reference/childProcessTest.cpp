// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/reference/childProcess.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <limits>
#include <unistd.h>

namespace polymesh {
namespace {

TEST(InChildProcess, returnsOneNumberPerTask) {
    const auto results =
        inChildProcess(5, 10, [](Label i) { return 2.5 * static_cast<double>(i); });
    ASSERT_EQ(results.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_EQ(results[i].value(), 2.5 * static_cast<double>(i));
    EXPECT_TRUE(inChildProcess(0, 10, [](Label) { return 0.0; }).empty());
}

TEST(InChildProcess, goesOnAfterACrashAnAbortAndAnExit) {
    const auto results = inChildProcess(8, 10, [](Label i) {
        if (i == 1) std::raise(SIGSEGV);
        if (i == 2) std::abort();
        if (i == 5) _exit(0);
        return i == 6 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(i);
    });
    ASSERT_EQ(results.size(), 8U);
    for (const std::size_t failed : {1U, 2U, 5U, 6U})
        EXPECT_FALSE(results[failed].has_value()) << failed;
    for (const std::size_t done : {0U, 3U, 4U, 7U})
        EXPECT_EQ(results[done].value(), static_cast<double>(done));
}

TEST(ChildWorker, answersManyNumbersAndGoesOnAfterACrash) {
    ChildWorker worker(10, [](const Numbers& question) {
        if (question.empty()) std::abort();
        Numbers answer;
        for (const double x : question)
            answer.push_back(2 * x);
        return answer;
    });
    const Numbers many(300000, 1.5);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(worker.ask(many), Numbers(many.size(), 3.0));
        EXPECT_FALSE(worker.ask({}).has_value());
    }
}

TEST(ChildWorker, ofWhichTwoLiveSideBySide) {
    ChildWorker one(10, [](const Numbers&) { return Numbers{1}; });
    ChildWorker two(10, [](const Numbers&) { return Numbers{2}; });
    EXPECT_EQ(one.ask({}), Numbers{1});
    EXPECT_EQ(two.ask({}), Numbers{2});
    EXPECT_EQ(one.ask({}), Numbers{1});
}

TEST(InChildProcess, endsATaskThatHangs) {
    const auto results = inChildProcess(2, 1, [](Label i) {
        if (i == 0) pause();
        return 1.0;
    });
    EXPECT_FALSE(results[0].has_value());
    EXPECT_EQ(results[1].value(), 1.0);
}

} // namespace
} // namespace polymesh
