// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QFrame>
#include <QList>
#include <QString>
#include <QTimer>

class QLabel;
class QPushButton;
class QToolButton;

namespace ui::kit {

/// Shows one message inside the window: what happened, what to do, and a button for doing it. If there are several
/// choices, the button opens a menu. An offer has a second button that declines it.
///
/// The newest message is shown at once, because it answers the last action. News disappears after kNewsMs. Warnings and
/// errors stay until the user closes them; then the message behind them is shown again.
class MessageBar : public QFrame
{
    Q_OBJECT
public:
    enum class Kind { News, Warning, Error };
    /// The subject of a message. withdraw() removes all messages of a subject that no longer apply.
    enum class Topic {
        General,
        Tooth,
        ResumableAttempt,
        Lesson,
        Keeping,
        Journal,
        Preset,
        School,
        Page,
        Device,
        Head,
        Pedal,
        Sound
    };
    struct Choice
    {
        QString text;
        std::function<void()> action;
    };
    struct Message
    {
        Kind kind = Kind::News;
        QString sentence;
        QString detail;      ///< in smaller type, below the sentence; may be empty
        QString actionText;  ///< empty: no button
        std::function<void()> action;
        Topic topic = Topic::General;
        QString technical = {};               ///< exact English text; shown as a tooltip
        QList<Choice> choices = {};           ///< the button's menu, instead of `action`
        Choice declining = {};                ///< the second button; hidden if its text is empty
        std::function<Message()> again = {};  ///< returns the message in the current language; empty: it is not
                                              ///< translated again
    };

    /// Time after which news disappears.
    static constexpr int kNewsMs = 7000;

    explicit MessageBar(QWidget* parent);

    void say(const Message& message);
    /// Shows a message. Retranslates it when the language changes, also while it is behind another message.
    void say(const std::function<Message()>& words);
    /// Closes the current message and shows the next one. Returns false if there was none.
    bool dismiss();
    /// Removes all messages of a topic, also those behind another message.
    void withdraw(Topic topic);

    /// Returns the sentence that is shown; empty if the bar is hidden.
    [[nodiscard]] QString sentence() const;
    /// Returns the topic of the message that is shown.
    [[nodiscard]] Topic topic() const { return m_now.topic; }
    /// Returns whether the message stays until the user closes it.
    [[nodiscard]] bool stays() const { return isVisibleTo(parentWidget()) && m_now.kind != Kind::News; }
    /// Where the bar is: over the middle of the tooth view, or in the title line of a page.
    enum class Place { OverTheView, BesideTheTitle };
    /// Places the bar at the top of `area` (coordinates of the parent), as wide as needed. Over the view, places it at
    /// the bottom if it would cover the bur.
    void placeIn(const QRect& area, Place place, const std::optional<QPointF>& bur = {});

signals:
    /// Emitted when another message, or none, is shown.
    void changed();

protected:
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void present(const Message& message);

    QLabel* m_icon;
    QLabel* m_sentence;
    QLabel* m_detail;
    QPushButton* m_button;
    QPushButton* m_decline;
    QToolButton* m_close;
    QTimer m_timer;
    QRect m_area;
    Place m_place = Place::OverTheView;
    Message m_now;
    QList<Message> m_waiting;
};

}  // namespace ui::kit
