// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QFrame>

#include "ui/presets/BlindTrial.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace ui::presets {

class FeedChart;
class SimplePanel;

/// Beside the tooth while a preset is tried on a block: its dials, felt at once, and the feed that they make; or two
/// presets behind "A" and "B", to be told apart by nothing but the hand.
class TrialCard : public QFrame
{
    Q_OBJECT
public:
    explicit TrialCard(QWidget* parent);

    /// While it is shown: another preset in the same trial.
    /// @param base  the version that `preset` was made of
    void tune(const core::settings::FeelPreset& base, const core::settings::FeelPreset& preset);
    void compare(const BlindTrial& trial);
    /// The preset as it is turned now; nothing in a comparison.
    [[nodiscard]] std::optional<core::settings::FeelPreset> tuned() const;
    /// Two presets are told apart, and what is felt is not told.
    [[nodiscard]] bool isComparing() const { return m_trial && !m_trial->isOver(); }
    /// The version that it is made of.
    [[nodiscard]] const core::settings::FeelPreset& base() const { return m_base; }
    /// @param bur        that is in hand, into core::bur::burs()
    /// @param handpiece  into core::settings::handpieces()
    /// @param cutMm3     of the block so far: who has cut with both may say which is better
    void follow(std::size_t bur, std::size_t handpiece, double cutMm3);

signals:
    /// This preset is to be felt from now on; in a comparison it is veiled().
    void felt(const core::settings::FeelPreset& preset);
    /// What the block is made of; felt() follows.
    void blockChosen(const core::settings::ToothKind& kind);
    /// The block is to be whole again: another trial begins.
    void freshBlockRequested();
    /// Back to the page of presets.
    void done();
    void csvRequested(const QByteArray& csv);

private:
    void makeAnswers();
    void makeBlockChoice();
    void takeBlock();
    void say();
    void draw();
    void turn(const core::settings::FeelPreset& preset);
    void beginAnew();
    void hold(BlindTrial::Answer letter);
    void answer(BlindTrial::Answer said);
    void end();

    QLabel* m_title;
    QLabel* m_words;
    QWidget* m_tuning;          ///< dials and chart
    QWidget* m_pane = nullptr;  ///< in which they scroll
    SimplePanel* m_dials;
    QWidget* m_blockChoice;
    QComboBox* m_block;
    FeedChart* m_chart;
    QPushButton* m_reset;
    QWidget* m_letters;
    QPushButton* m_a;
    QPushButton* m_b;
    QWidget* m_answers;
    QPushButton* m_csv;
    QPushButton* m_end;
    QPushButton* m_back;
    core::settings::FeelPreset m_base;
    core::settings::FeelPreset m_asItWas;  ///< before anything was turned in this trial
    std::optional<core::settings::FeelPreset> m_tuned;
    std::optional<BlindTrial> m_trial;
    BlindTrial::Answer m_held = BlindTrial::Answer::A;
    double m_cutMm3 = 0.0;    ///< when it was last told; beyond all until it is told of a new block
    bool m_cutWithA = false;  ///< in this trial
    bool m_cutWithB = false;
};

}  // namespace ui::presets
