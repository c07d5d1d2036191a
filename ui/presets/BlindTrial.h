// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <QByteArray>

#include "core/settings/FeelPreset.h"

namespace ui::presets {

/// Two presets behind the letters A and B, drawn anew for each trial, so that nobody knows which is which and a habit
/// of saying "A" says nothing.
class BlindTrial
{
public:
    enum class Answer { A, B, NoDifference };
    /// What the trials came to.
    struct Outcome
    {
        int first = 0;  ///< times that the first preset was chosen
        int second = 0;
        int neither = 0;
        /// Probability that guessing alone leads at least so far from even, two-sided binomial; those without a choice
        /// are left out. 1 without any choice.
        double p = 1.0;
    };

    /// @param trials  1 to 100
    BlindTrial(core::settings::FeelPreset first, core::settings::FeelPreset second, int trials, std::uint64_t seed);

    [[nodiscard]] int trials() const { return m_trials; }
    /// From 1; trials() + 1 when it is over.
    [[nodiscard]] int trial() const { return static_cast<int>(m_answers.size()) + 1; }
    [[nodiscard]] bool isOver() const { return trial() > trials(); }
    /// Of the present trial.
    [[nodiscard]] const core::settings::FeelPreset& behind(Answer letter) const;
    void answer(Answer said);
    /// Before all have been answered: what was answered counts.
    void end() { m_trials = static_cast<int>(m_answers.size()); }

    [[nodiscard]] const core::settings::FeelPreset& first() const { return m_presets[0]; }
    [[nodiscard]] const core::settings::FeelPreset& second() const { return m_presets[1]; }
    [[nodiscard]] Outcome outcome() const;
    /// A row a trial: trial,behind_a,behind_b,answer,chosen. In the C locale.
    [[nodiscard]] QByteArray csv() const;

private:
    std::array<core::settings::FeelPreset, 2> m_presets;
    int m_trials;
    std::vector<bool> m_firstIsA;  ///< one a trial
    std::vector<Answer> m_answers;
};

/// As it is felt while nobody is to know what it is: its numbers, and no name.
[[nodiscard]] core::settings::FeelPreset veiled(core::settings::FeelPreset preset);
[[nodiscard]] bool isVeiled(const core::settings::FeelPreset& preset);

/// Two-sided exact binomial test of `hits` in `of` against a fair coin.
[[nodiscard]] double binomialP(int hits, int of);

}  // namespace ui::presets
