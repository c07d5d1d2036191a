// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "bench/Suites.h"
#include "core/base/Rng.h"
#include "haptics/falcon/Kinematics.h"
#include "haptics/falcon/Packets.h"
#include "haptics/simulated/Simulation.h"

namespace bench {
namespace {

using namespace haptics::falcon;

constexpr int kBlocks = 400;
constexpr int kPerBlock = 500;
constexpr double kStrideMm = 0.1;  ///< motion of a hand in a tick: 100 mm/s at 1 kHz
constexpr double kAwayMm = 40.0;

/// Times a function in blocks, so that the clock itself costs nothing, and returns the time of one call, microseconds.
template <class Work>
haptics::TickTimes timed(Work work)
{
    haptics::TickTimes times;
    for (int block = 0; block < kBlocks; ++block) {
        const double before = haptics::threadCpuUs();
        for (int n = 0; n < kPerBlock; ++n)
            work(block * kPerBlock + n);
        times.add((haptics::threadCpuUs() - before) / kPerBlock);
    }
    return times;
}

void add(Figures& figures, const QString& key, const QString& what, const haptics::TickTimes& times,
         const QString& reach)
{
    constexpr double kMost = 0.99;
    figures.append({QStringLiteral("falcon_%1_p50_us").arg(key), what + QStringLiteral(", p50"),
                    times.percentileUs(0.5), QStringLiteral("us"), reach});
    figures.append({QStringLiteral("falcon_%1_p99_us").arg(key), what + QStringLiteral(", p99"),
                    times.percentileUs(kMost), QStringLiteral("us"), reach});
}

}  // namespace

core::Result<Figures> falconSuite(const Context& context)
{
    core::Rng rng(1);
    std::vector<glm::dvec3> grips;
    std::vector<glm::dvec3> angles;
    while (grips.size() < kPerBlock) {
        const glm::dvec3 grip = kCentreMm + glm::dvec3(rng.uniform(-kAwayMm, kAwayMm), rng.uniform(-kAwayMm, kAwayMm),
                                                       rng.uniform(-kAwayMm, kAwayMm)) *
                                                0.5;
        if (const auto arms = armsAt(grip)) {
            grips.push_back(grip);
            angles.push_back(arms->angleRad);
        }
    }
    double sum = 0.0;  // keeps the compiler from removing the work
    context.progress(QStringLiteral("the exchange"), 0, 4);
    FrameReader reader;
    std::array<std::uint8_t, kUsbStatusBytes + kFrameBytes> transfer{0x01, 0x60};
    const auto exchange = timed([&](int n) {
        const Frame frame = encode({.motors = {static_cast<std::int16_t>(n), static_cast<std::int16_t>(-n),
                                               static_cast<std::int16_t>(n / 2)}});
        std::copy(frame.begin(), frame.end(), transfer.begin() + kUsbStatusBytes);
        sum += reader.read(transfer).newest.counts[0];
    });
    context.progress(QStringLiteral("forward kinematics"), 1, 4);
    const auto warm = timed([&](int n) {
        const auto k = static_cast<std::size_t>(n % kPerBlock);
        sum += gripAt(angles[k], grips[k] + glm::dvec3(kStrideMm, 0.0, 0.0)).value_or(kCentreMm).x;
    });
    context.progress(QStringLiteral("forward kinematics"), 2, 4);
    const auto cold = timed([&](int n) {
        sum += gripAt(angles[static_cast<std::size_t>(n % kPerBlock)], kCentreMm).value_or(kCentreMm).x;
    });
    context.progress(QStringLiteral("motor commands"), 3, 4);
    const auto commands = timed([&](int n) {
        if (const auto arms = armsAt(grips[static_cast<std::size_t>(n % kPerBlock)]))
            sum += motorCommands(*arms, {0.1, 0.2, 0.3}, {})[0];
    });
    if (!(sum > -1.0e300))
        return core::unexpected(core::ErrorCode::BadNumber, "the kinematics gave no number");
    Figures figures;
    add(figures, QStringLiteral("exchange"), QStringLiteral("a request encoded and an answer decoded"), exchange,
        QStringLiteral("1 us"));
    add(figures, QStringLiteral("forward_warm"), QStringLiteral("forward kinematics from a tick ago"), warm,
        QStringLiteral("2 us"));
    add(figures, QStringLiteral("forward_cold"), QStringLiteral("forward kinematics from the middle"), cold,
        QStringLiteral("10 us"));
    add(figures, QStringLiteral("commands"), QStringLiteral("motor commands for a force"), commands, {});
    return figures;
}

}  // namespace bench
