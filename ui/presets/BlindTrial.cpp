// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/presets/BlindTrial.h"

#include <algorithm>
#include <cmath>

#include "core/base/Rng.h"

namespace ui::presets {
namespace {

using core::settings::FeelPreset;

/// Returns the name in quotes, with quotes inside it doubled (RFC 4180).
QByteArray quoted(const FeelPreset& preset)
{
    return '"' + QByteArray::fromStdString(core::settings::labelOf(preset)).replace("\"", "\"\"") + '"';
}

}  // namespace

double binomialP(int hits, int of)
{
    const auto logChance = [of](int k) {
        return std::lgamma(of + 1.0) - std::lgamma(k + 1.0) - std::lgamma(of - k + 1.0) - of * std::log(2.0);
    };
    const double observed = logChance(hits);
    double p = 0.0;
    for (int k = 0; k <= of; ++k)
        if (const double chance = logChance(k); chance <= observed + 1.0e-9)
            p += std::exp(chance);
    return std::min(1.0, p);
}

FeelPreset veiled(FeelPreset preset)
{
    preset.name.clear();
    preset.notes.clear();
    preset.hash.clear();
    preset.version = 0;
    return preset;
}

bool isVeiled(const FeelPreset& preset)
{
    return preset.name.empty();
}

BlindTrial::BlindTrial(FeelPreset first, FeelPreset second, int trials, std::uint64_t seed)
    : m_presets{std::move(first), std::move(second)}, m_trials(std::clamp(trials, 1, 100))
{
    core::Rng rng(seed);
    for (int k = 0; k < m_trials; ++k)
        m_firstIsA.push_back(rng.below(2) == 0);
}

const FeelPreset& BlindTrial::behind(Answer letter) const
{
    const bool firstIsA = m_firstIsA.at(std::min(m_answers.size(), m_firstIsA.size() - 1));
    return m_presets.at((letter == Answer::A) == firstIsA ? 0 : 1);
}

void BlindTrial::answer(Answer said)
{
    if (!isOver())
        m_answers.push_back(said);
}

BlindTrial::Outcome BlindTrial::outcome() const
{
    Outcome outcome;
    for (std::size_t k = 0; k < m_answers.size(); ++k) {
        if (m_answers[k] == Answer::NoDifference)
            ++outcome.neither;
        else
            ++((m_answers[k] == Answer::A) == m_firstIsA[k] ? outcome.first : outcome.second);
    }
    if (const int chosen = outcome.first + outcome.second; chosen > 0)
        outcome.p = binomialP(outcome.first, chosen);
    return outcome;
}

QByteArray BlindTrial::csv() const
{
    QByteArray lines = "trial,behind_a,behind_b,answer,chosen\n";
    for (std::size_t k = 0; k < m_answers.size(); ++k) {
        const QByteArray a = quoted(m_presets[m_firstIsA[k] ? 0 : 1]);
        const QByteArray b = quoted(m_presets[m_firstIsA[k] ? 1 : 0]);
        const Answer said = m_answers[k];
        lines += QByteArray::number(static_cast<int>(k) + 1) + ',' + a + ',' + b + ',' +
                 (said == Answer::A   ? "A," + a
                  : said == Answer::B ? "B," + b
                                      : QByteArray("no difference,")) +
                 '\n';
    }
    return lines;
}

}  // namespace ui::presets
