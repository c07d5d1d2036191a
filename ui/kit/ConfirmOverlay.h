// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QPointer>
#include <QString>
#include <QWidget>

class QFrame;
class QPushButton;

namespace ui::kit {

/// A question inside the window, before something would be lost: three answers, or two where nobody here can save it,
/// over a veil that keeps the rest of the window and its keys waiting. Esc, and a click on the veil, leave all as it
/// is. It goes when it is answered. Without `discard`, nothing would be lost, and the card only asks whether to begin.
class ConfirmOverlay final : public QWidget
{
    Q_OBJECT
public:
    struct Question
    {
        QString text;
        QString detail;    ///< quieter, beneath
        QString saveText;  ///< of the answer that loses nothing; empty: there is none but to stay
        std::function<void()> save;
        std::function<void()> discard;
        QString stayText = {};  ///< of the answer that changes nothing, if there is no saveText; empty: the usual one
        QString drawing = QStringLiteral("warning");  ///< of its icon
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
    QPointer<QWidget> m_before;  ///< which had the keys
};

}  // namespace ui::kit
