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

/// One message inside the window: what happened, what to do, and a button for doing it; where there are several things
/// to choose from, the button opens a menu of them. An offer has a second button, for declining it.
///
/// The newest comes at once: it answers what was just done. News goes away by itself, warnings and errors stay until
/// they are closed; then what they covered comes back.
class MessageBar : public QFrame
{
    Q_OBJECT
public:
    enum class Kind { News, Warning, Error };
    /// What a message is about: one about a tooth that is no longer on the table is taken back, and so is the offer of
    /// an attempt that was taken up or discarded, and that a grade is not kept, or an attempt while it is made, once it
    /// is. What cannot be read of the school is over once something can, and that a preset was kept when another is
    /// refused. What is said of a lesson's course stays in the practice room, and what could not be read for a page is
    /// over when another is opened, or it is read again. What is said of a device, or of
    /// head tracking, is over when its state is another.
    /// What somebody has typed is for nobody else.
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
        QString detail;      ///< quieter, beneath; may be empty
        QString actionText;  ///< empty: no button
        std::function<void()> action;
        Topic topic = Topic::General;
        QString technical = {};               ///< exact and English, for whoever points at the message
        QList<Choice> choices = {};           ///< of the button's menu, in place of `action`
        Choice declining = {};                ///< the second button; no text: none
        std::function<Message()> again = {};  ///< in the language of the moment; empty: it stays as it was said
    };

    /// How long news stays.
    static constexpr int kNewsMs = 7000;

    explicit MessageBar(QWidget* parent);

    void say(const Message& message);
    /// Says it again in each language that is chosen while it stands or waits: who cannot read it changes the language.
    void say(const std::function<Message()>& words);
    /// Closes the present message; the next one follows. False when there was none.
    bool dismiss();
    /// Takes back every message of a topic, shown or waiting.
    void withdraw(Topic topic);

    [[nodiscard]] QString sentence() const;
    /// Of the message that is shown.
    [[nodiscard]] Topic topic() const { return m_now.topic; }
    /// It stands until somebody closes it.
    [[nodiscard]] bool stays() const { return isVisibleTo(parentWidget()) && m_now.kind != Kind::News; }
    /// Over the middle of the tooth's view; on a page in the line of its title, or above the page where it stays.
    enum class Place { OverTheView, BesideTheTitle };
    /// Puts the bar at the top of `area` (parent's coordinates), as wide as it needs. Over the view, puts it at the
    /// foot if it would cover the bur.
    void placeIn(const QRect& area, Place place, const std::optional<QPointF>& bur = {});

signals:
    /// Another message is shown, or none any more.
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
