// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <QObject>
#include <glm/mat4x4.hpp>

#include "core/grading/IdealCavity.h"
#include "core/session/SessionChannels.h"
#include "lessons/Lesson.h"
#include "ui/kit/MessageBar.h"
#include "ui/replay/AttemptTimeline.h"
#include "ui/tooth/ExerciseMarks.h"
#include "ui/window/PracticeState.h"

class QMenu;

namespace ui::kit {
class Actions;
}
namespace ui::tooth {
class ToothView;
struct ViewSettings;
}  // namespace ui::tooth

namespace ui::window {

class FileDialogs;
class Navigation;
class PracticeRoom;

/// Shows the replay of a recording in the practice room: its bar and timeline, comments, and another attempt beside it.
class ReplayView final : public QObject
{
    Q_OBJECT
public:
    ReplayView(PracticeState& state, PracticeRoom& room, kit::Actions& actions, tooth::ToothView& view,
               kit::MessageBar& messages, FileDialogs& files, const Navigation& navigation);

    /// Begins or ends a replay. The caller shows the tooth afterwards.
    /// @param ideal   ideal of the recorded tooth; null: there is none
    /// @param lesson  lesson of the recording; unset: free practice
    /// @param whose   name of the student and time of the attempt; empty: unknown
    void setReplaying(bool replaying, double lengthS, core::grading::IdealTop ideal,
                      std::optional<lessons::Lesson> lesson, const QString& whose);
    [[nodiscard]] const core::grading::IdealTop& ideal() const { return m_ideal; }
    [[nodiscard]] const QString& whose() const { return m_whose; }
    /// Sets the timeline of the attempt. Call it again when more of the timeline has been computed.
    void setCourse(const replay::AttemptTimeline& course);
    void setRemarks(std::vector<replay::Remark> remarks);
    /// Shows the present moment of the recording.
    void follow();
    void showPaused(bool paused);
    /// Shows that the recording has ended and is paused.
    void showEnd();
    /// Shows that the device no longer guides the hand.
    /// @param pushed  true: the user pushed against the device; false: the device was lost
    void showLeadEnd(bool pushed);
    /// Shows a sentence with a button that stops the replay.
    void offerToStop(const QString& sentence);

    /// Shows another attempt beside the replay, seen from the same side.
    /// @param links  channels of that attempt; must be valid until hideBeside()
    void showBeside(core::session::UiChannels& links, const std::shared_ptr<const core::terrain::ToothAnatomy>& tooth,
                    std::uint64_t generation, const core::grading::IdealTop& ideal, const QString& name);
    void setBesideCourse(const replay::AttemptTimeline& course);
    void hideBeside();
    /// Offers attempts, and a file, to show beside the replay. If there are no attempts, opens the file dialog at once.
    void offerBeside(const QList<kit::MessageBar::Choice>& attempts);
    /// Returns the view of the attempt that is shown beside the replay, or null.
    [[nodiscard]] tooth::ToothView* beside() const { return m_beside; }

    struct Points
    {
        std::vector<tooth::PointMark> replayed;
        std::vector<tooth::PointMark> beside;
        bool operator==(const Points&) const = default;
    };
    /// Returns the points of the exercise, as touched up to the present moment of the recording. In the attempt beside,
    /// this is the moment at the same share of its length.
    [[nodiscard]] Points points() const;

signals:
    void stopRequested();
    void pauseRequested(bool paused);
    /// Emitted when the user chooses another speed.
    /// @param times  0.1 to 16 times as fast as the recording was made. A replay begins with 1
    void speedChosen(double times);
    /// Emitted when the user goes to another moment.
    /// @param seconds  from the start of the recording
    void seekRequested(double seconds);
    /// Emitted when the user requests that the device guides their hand along the replay, or stops that.
    void leadRequested(bool on);
    /// Emitted when the user requests to show another attempt beside. The receiver calls offerBeside().
    /// @param lesson  id of the lesson of the replay; empty: free practice
    void besidesRequested(const std::string& lesson, const std::string& tooth);
    void besideRequested(const QString& path);
    void besideCloseRequested();
    /// Emitted when the user requests to play the recording of the lesson's author, or to show it beside.
    void expertRequested();
    /// Emitted when a moment is shown in the practice room.
    /// @param seconds  from the start of the recording
    void shown(double seconds);
    /// Emitted when points() may have changed.
    void pointsChanged();
    /// Emitted when actions and overlays need an update.
    void changed();

private:
    void connectBar();
    void pause(bool paused);
    void showCourse();
    void showRemarks();
    void lookAlike();
    void askForBeside();
    [[nodiscard]] QPoint aboveBesideButton(const QMenu& menu) const;
    [[nodiscard]] replay::AttemptTimeline withoutSecrets(replay::AttemptTimeline course) const;

    PracticeState& m_state;
    PracticeRoom& m_room;
    kit::Actions& m_actions;
    tooth::ToothView& m_view;
    kit::MessageBar& m_messages;
    FileDialogs& m_files;
    const Navigation& m_navigation;
    core::grading::IdealTop m_ideal;
    QString m_whose;
    replay::AttemptTimeline m_course;
    replay::AttemptTimeline m_besideCourse;
    std::vector<replay::Remark> m_remarked;  ///< comments on the moment that is shown
    Points m_followed;                       ///< points() at the last call of follow()
    bool m_isPaused = false;
    tooth::ToothView* m_beside = nullptr;
    glm::dmat4 m_sharedLook{1.0};  ///< view matrix of both cameras
};

}  // namespace ui::window
