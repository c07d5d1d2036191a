// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QWidget>

namespace ui::kit {

/// Asks for confirmation within a part of a page before an irreversible action. Pressing Esc or hiding the part cancels
/// the question.
class InlineConfirmation final : public QObject
{
    Q_OBJECT
public:
    explicit InlineConfirmation(QWidget& part);

    [[nodiscard]] bool isAsked() const { return m_isAsked; }
    void ask();
    /// Returns whether a click may count as the answer. Returns false for the time of two double clicks after ask(), so
    /// that a double click does not confirm.
    [[nodiscard]] bool mayBeAnswered() const;
    /// Ends the question without a signal.
    void end();

signals:
    /// Emitted when the user has pressed Esc or left the part.
    void withdrawn();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool m_isAsked = false;
    QElapsedTimer m_sinceAsked;
};

}  // namespace ui::kit
