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

/// A line to type commands into, over the view: every registered parameter can be listed, read, set, watched and
/// plotted while one drills, and what is set kept as a preset. It takes the pointer and the keys only inside itself.
class Console : public QWidget
{
    Q_OBJECT
public:
    /// Keeps what is felt now under a name, or feels what is kept under it; a sentence to be shown either way.
    /// Answers what it did, or nothing: then say() follows.
    using Preset = std::function<QString(const QString& name)>;
    /// Those that are kept, for Tab.
    using PresetNames = std::function<QStringList()>;

    /// @param parameters, panel  must outlive the console
    Console(const core::settings::Parameters& parameters, WatchPanel& panel, QWidget* parent);

    void setPresets(Preset save, Preset load, PresetNames names);
    void say(const QString& text);
    /// As if the line had been typed: its answer is appended to the output.
    void execute(const QString& line);
    /// What Tab would make of a line that has been begun.
    [[nodiscard]] QString completed(const QString& line) const;
    /// Somebody else works here: what was typed, answered and watched is gone, and so is the console.
    void forget();
    /// Shows itself, the line ready for typing.
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
