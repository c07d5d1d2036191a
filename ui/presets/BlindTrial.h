// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <QByteArray>

#include "core/settings/FeelPreset.h"

namespace ui::presets {

/// A blind comparison of two presets named A and B. The names are assigned at random for each trial, so that a habit of
/// answering "A" has no effect.
class BlindTrial
{
public:
    enum class Answer { A, B, NoDifference };
    /// The result of all trials.
    struct Outcome
    {
        int first = 0;  ///< number of times that the first preset was chosen
        int second = 0;
        int neither = 0;
        /// Probability that guessing gives a result at least this far from even: two-sided binomial, without the trials
        /// that had no choice. 1 if there was no choice.
        double p = 1.0;
    };

    /// @param trials  1 to 100
    BlindTrial(core::settings::FeelPreset first, core::settings::FeelPreset second, int trials, std::uint64_t seed);

    [[nodiscard]] int trials() const { return m_trials; }
    /// Returns the number of the current trial, from 1. Returns trials() + 1 when the comparison is over.
    [[nodiscard]] int trial() const { return static_cast<int>(m_answers.size()) + 1; }
    [[nodiscard]] bool isOver() const { return trial() > trials(); }
    /// Returns the preset that has a letter in the current trial.
    [[nodiscard]] const core::settings::FeelPreset& behind(Answer letter) const;
    void answer(Answer said);
    /// Ends the comparison early. The answers so far are counted.
    void end() { m_trials = static_cast<int>(m_answers.size()); }

    [[nodiscard]] const core::settings::FeelPreset& first() const { return m_presets[0]; }
    [[nodiscard]] const core::settings::FeelPreset& second() const { return m_presets[1]; }
    [[nodiscard]] Outcome outcome() const;
    /// Returns a row per trial: trial,behind_a,behind_b,answer,chosen. In the C locale.
    [[nodiscard]] QByteArray csv() const;

private:
    std::array<core::settings::FeelPreset, 2> m_presets;
    int m_trials;
    std::vector<bool> m_firstIsA;  ///< one per trial
    std::vector<Answer> m_answers;
};

/// Returns a preset with its numbers but without its name, so that users cannot tell which preset they feel.
[[nodiscard]] core::settings::FeelPreset veiled(core::settings::FeelPreset preset);
[[nodiscard]] bool isVeiled(const core::settings::FeelPreset& preset);

/// Returns the p-value of a two-sided exact binomial test of `hits` in `of` against a fair coin.
[[nodiscard]] double binomialP(int hits, int of);

}  // namespace ui::presets
