// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <QJsonArray>
#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QTimer>

#include "ui/shell/PutBy.h"

namespace ui::admin {
class PeoplePart;
}
namespace ui::people {
class TalkPanel;
}
namespace ui::presets {
class PresetsPage;
}
namespace ui::study {
class LessonEditor;
}

namespace ui::shell {

class MessageBar;

/// What people have typed on the pages of a window and kept nowhere yet: it lies on the disk every few seconds, comes
/// back to its page at the next start, and where its page has another draft of the same by then, whose it is says which
/// of them stays. Ui thread.
class Drafts final : public QObject
{
    Q_OBJECT

public:
    /// The pages on which something is typed; they outlive this.
    struct Pages
    {
        study::LessonEditor& editor;
        people::TalkPanel& talk;
        presets::PresetsPage& presets;
        admin::PeoplePart& people;
    };
    /// Who stands at the window.
    struct Reader
    {
        /// Whether he may be told of what this person has typed, and decide on it.
        std::function<bool(const QString& personUid)> isWriter;
        /// The same of drafts of lessons, and of what nobody can read: they are nobody's in particular.
        std::function<bool()> mayEdit;
        /// Its owner has locked the place, and may be anybody.
        std::function<bool()> isLockedOut;
    };

    Drafts(const Pages& pages, MessageBar& messages, Reader reader, QObject* parent);

    /// Takes back to the pages what lies there, and writes there from now on.
    /// @param school  see PutBy
    void setFolder(const QString& folder, const QString& school);
    /// Tells who works here of what has no place, once.
    void tell();
    /// What was typed on this attempt can be thrown away: the attempt is there no more.
    void tellOfNothing(qint64 attempt);
    /// Whoever comes next is told afresh.
    void forgetTold();
    /// While the window goes on: all there is, decided on or not.
    void putBy();
    /// When the window is closed: what whoever stands here may not decide on. False: there is something, and it is
    /// written nowhere.
    [[nodiscard]] bool putOthersBy();
    /// What is left was decided on.
    void stop();

signals:
    /// One was taken back on this attempt, or on a preset: its page is to be shown.
    void attemptWanted(qint64 attempt);
    void presetsWanted();

private:
    [[nodiscard]] bool goOnWith(const QJsonObject& typed);
    [[nodiscard]] bool mayDecideOn(const QJsonObject& typed) const;
    [[nodiscard]] QJsonArray all(bool lessons, bool withOwn) const;
    void tellOf(const QJsonObject& typed);
    void takeInstead(const QJsonObject& typed);
    void drop(const QJsonObject& typed);

    Pages m_pages;
    MessageBar& m_messages;
    Reader m_reader;
    QTimer m_beat;
    std::unique_ptr<PutBy> m_putBy;  ///< null: there is no place for it
    QJsonArray m_unclaimed;          ///< of what was put by, what nothing can be made of here and now
    QJsonArray m_told;               ///< of it, what who works here has been told of
};

}  // namespace ui::shell
