// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QWidget>

namespace ui::kit {

/// Asks once more, within a part of a page, before something is done that nobody can undo. Esc, and leaving the part,
/// withdraw it.
class InlineConfirmation final : public QObject
{
    Q_OBJECT
public:
    explicit InlineConfirmation(QWidget& part);

    [[nodiscard]] bool isAsked() const { return m_isAsked; }
    void ask();
    /// It is being asked, and a click is an answer: the second of a double click is none.
    [[nodiscard]] bool mayBeAnswered() const;
    /// It is answered, or nobody asks any more.
    void end();

signals:
    /// It is not to be done.
    void withdrawn();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool m_isAsked = false;
    QElapsedTimer m_sinceAsked;
};

}  // namespace ui::kit
