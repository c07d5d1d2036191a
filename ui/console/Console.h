// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QStringList>
#include <QWidget>

#include "core/base/Result.h"
#include "core/settings/Parameters.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace ui::console {

class WatchPanel;

/// A command line over the view. Every registered parameter can be listed, read, set, watched and plotted while the
/// user drills, and hardness and force can be saved as a preset. The console receives mouse and key events only inside
/// itself.
class Console : public QWidget
{
    Q_OBJECT
public:
    /// Saves the current hardness and force as a preset, or loads one. Returns a sentence about the result; empty:
    /// say() follows.
    using Preset = std::function<QString(const QString& name)>;
    /// Returns the names of the presets, for completion.
    using PresetNames = std::function<QStringList()>;

    /// @param parameters, panel  must outlive the console
    Console(const core::settings::Parameters& parameters, WatchPanel& panel, QWidget* parent);

    void setPresets(Preset save, Preset load, PresetNames names);
    void say(const QString& text);
    /// Executes a line as if it had been typed, and appends the answer to the output.
    void execute(const QString& line);
    /// Returns the line after Tab has completed it.
    [[nodiscard]] QString completed(const QString& line) const;
    /// Clears input, output and the watched values, and hides the console. Call this for another user.
    void forget();
    /// Shows the console and sets the focus to its input line.
    void open();

signals:
    void closeRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void hint();
    [[nodiscard]] QString askForPreset(const Preset& what, const QString& name);
    void list(const QString& text);
    void get(const QString& name);
    void set(const QString& name, const QString& value);
    void reset(const QString& name);
    void watch(const QString& name, bool plotted);
    void exportPlot(const QString& name, const QString& file);
    void recall(int step);
    [[nodiscard]] QStringList candidates(const QString& line) const;

    const core::settings::Parameters& m_parameters;
    WatchPanel& m_panel;
    Preset m_save;
    Preset m_load;
    PresetNames m_presetNames;
    QPlainTextEdit* m_output;
    QLabel* m_hint;
    QLineEdit* m_line;
    QStringList m_history;
    qsizetype m_recalled = 0;
};

}  // namespace ui::console
