// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QFrame>

#include "ui/presets/BlindTrial.h"

class QLabel;
class QPushButton;

namespace ui::presets {

class SimplePanel;

/// Over the tooth while a preset is tried on a block: its dials, felt at once; or two presets behind "A" and "B", to be
/// told apart by nothing but the hand.
class TrialCard : public QFrame
{
    Q_OBJECT
public:
    explicit TrialCard(QWidget* parent);

    void tune(const core::settings::FeelPreset& preset);
    void compare(const BlindTrial& trial);
    /// The preset as it is turned now; nothing in a comparison.
    [[nodiscard]] std::optional<core::settings::FeelPreset> tuned() const;

signals:
    /// This preset is to be felt from now on.
    void felt(const core::settings::FeelPreset& preset);
    /// The block is to be whole again: another trial begins.
    void freshBlockWanted();
    /// Back to the page of presets.
    void done();
    void csvWanted(const QByteArray& csv);

private:
    void say();
    void hold(BlindTrial::Answer letter);
    void answer(BlindTrial::Answer said);

    QLabel* m_title;
    QLabel* m_words;
    SimplePanel* m_dials;
    QPushButton* m_reset;
    QWidget* m_letters;
    QPushButton* m_a;
    QPushButton* m_b;
    QWidget* m_answers;
    QPushButton* m_csv;
    std::optional<core::settings::FeelPreset> m_tuned;
    std::optional<BlindTrial> m_trial;
    BlindTrial::Answer m_held = BlindTrial::Answer::A;
};

}  // namespace ui::presets
