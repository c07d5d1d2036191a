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

/// A card beside the tooth while a preset is tried on a practice block. It shows the preset's dials, which take effect
/// at once, and the resulting feed; or a blind comparison of two presets "A" and "B".
class TrialCard : public QFrame
{
    Q_OBJECT
public:
    explicit TrialCard(QWidget* parent);

    /// Starts a trial of a preset, or sets another preset in the current trial.
    /// @param base  the version that `preset` is based on
    void tune(const core::settings::FeelPreset& base, const core::settings::FeelPreset& preset);
    void compare(const BlindTrial& trial);
    /// Returns the preset as set by the dials. Empty in a comparison.
    [[nodiscard]] std::optional<core::settings::FeelPreset> tuned() const;
    /// Returns whether a comparison is running. Its values must stay hidden.
    [[nodiscard]] bool isComparing() const { return m_trial && !m_trial->isOver(); }
    /// Returns the version that the preset is based on.
    [[nodiscard]] const core::settings::FeelPreset& base() const { return m_base; }
    /// Shows what has been cut so far.
    /// @param bur        the bur in use, index into core::bur::burs()
    /// @param handpiece  index into core::settings::handpieces()
    /// @param cutMm3     volume cut from the block so far; the user can answer after cutting with both presets
    void follow(std::size_t bur, std::size_t handpiece, double cutMm3);

signals:
    /// Emitted when this preset must take effect. In a comparison it is veiled().
    void felt(const core::settings::FeelPreset& preset);
    /// Emitted when the user chooses the material of the block; felt() follows.
    void blockChosen(const core::settings::ToothKind& kind);
    /// Emitted when the block must be restored for another trial.
    void freshBlockRequested();
    /// Emitted when the user returns to the page of presets.
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
    QWidget* m_pane = nullptr;  ///< scrolls m_tuning
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
    core::settings::FeelPreset m_asItWas;  ///< the preset before any change in this trial
    std::optional<core::settings::FeelPreset> m_tuned;
    std::optional<BlindTrial> m_trial;
    BlindTrial::Answer m_held = BlindTrial::Answer::A;
    double m_cutMm3 = 0.0;    ///< the last reported volume; the largest number until a new block is reported
    bool m_cutWithA = false;  ///< in this trial
    bool m_cutWithB = false;
};

}  // namespace ui::presets
