// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QPointer>
#include <QString>
#include <QWidget>

class QFrame;
class QPushButton;

namespace ui::kit {

/// A modal question inside the window, asked before data would be lost. It has buttons to discard, to cancel and, if
/// possible, to save. An overlay blocks the rest of the window and its shortcuts. Esc and a click beside the question
/// cancel. The object deletes itself after an answer. Without `discard` no data is at risk, and the question only asks
/// for confirmation.
class ConfirmOverlay final : public QWidget
{
    Q_OBJECT
public:
    struct Question
    {
        QString text;
        QString detail;    ///< in smaller type, below the text
        QString saveText;  ///< text of the button that saves; empty: saving is not possible
        std::function<void()> save;
        std::function<void()> discard;
        QString discardText = {};  ///< text of the button that discards; empty: "Discard"
        QString stayText = {};     ///< text of the button that cancels, if saveText is empty; empty: "Stay"
        QString drawing = QStringLiteral("warning");  ///< name of its icon
    };

    ConfirmOverlay(const Question& question, QWidget* parent);

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void answer(const std::function<void()>& doing);
    void place();

    QFrame* m_card;
    QList<QPushButton*> m_answers;
    QPointer<QWidget> m_before;  ///< the widget that had the focus
};

}  // namespace ui::kit
