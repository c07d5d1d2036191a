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

/// The replay of a recording in the practice room: its bar and time line, remarks, and another attempt beside it.
class ReplayView final : public QObject
{
    Q_OBJECT
public:
    ReplayView(PracticeState& state, PracticeRoom& room, kit::Actions& actions, tooth::ToothView& view,
               kit::MessageBar& messages, FileDialogs& files, const Navigation& navigation);

    /// Begins or ends a replay. The caller shows the tooth afterwards.
    /// @param ideal   of the recorded tooth; null: there is none
    /// @param lesson  of the recording; unset: free practice
    /// @param whose   the student and the time of the attempt; empty: unknown
    void setReplaying(bool replaying, double lengthS, core::grading::IdealTop ideal,
                      std::optional<lessons::Lesson> lesson, const QString& whose);
    [[nodiscard]] const core::grading::IdealTop& ideal() const { return m_ideal; }
    [[nodiscard]] const QString& whose() const { return m_whose; }
    /// Sets what is known of the attempt. Called again when more is known.
    void setCourse(const replay::AttemptTimeline& course);
    void setRemarks(std::vector<replay::Remark> remarks);
    /// Shows the present moment of the recording.
    void follow();
    void showPaused(bool paused);
    /// The recording has ended and is paused.
    void showEnd();
    /// The device no longer leads the hand.
    /// @param pushed  the user pushed against it; otherwise the device is lost
    void showLeadEnd(bool pushed);
    /// Shows a sentence with a button that stops the replay.
    void offerToStop(const QString& sentence);

    /// Shows another attempt beside the replay, seen from the same side.
    /// @param links  its tooth; must outlive the view until hideBeside()
    void showBeside(core::session::UiChannels& links, const std::shared_ptr<const core::terrain::ToothAnatomy>& tooth,
                    std::uint64_t generation, const core::grading::IdealTop& ideal, const QString& name);
    void setBesideCourse(const replay::AttemptTimeline& course);
    void hideBeside();
    /// Offers attempts to show beside the replay, and a file. Without attempts it asks for a file at once.
    void offerBeside(const QList<kit::MessageBar::Choice>& attempts);
    /// Null unless an attempt is beside.
    [[nodiscard]] tooth::ToothView* beside() const { return m_beside; }

    struct Points
    {
        std::vector<tooth::PointMark> replayed;
        std::vector<tooth::PointMark> beside;
        bool operator==(const Points&) const = default;
    };
    /// Returns the points of the exercise in the recording, and in the one beside at the same share of its time.
    [[nodiscard]] Points points() const;

signals:
    void stopRequested();
    void pauseRequested(bool paused);
    /// @param times  0.1 to 16 times as fast as the recording was made. A replay begins with 1
    void speedChosen(double times);
    /// @param seconds  a moment of the recording
    void seekRequested(double seconds);
    /// The device shall lead the hand along the replay, or stop that.
    void leadRequested(bool on);
    /// Asks for attempts to show beside; offerBeside() answers.
    /// @param lesson  id of the lesson of the replay; empty: free practice
    void besidesRequested(const std::string& lesson, const std::string& tooth);
    void besideRequested(const QString& path);
    void besideCloseRequested();
    /// Emitted when the recording of the lesson's author shall be played, or shown beside.
    void expertRequested();
    /// Emitted when a moment is shown in the room, s since the beginning.
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
    std::vector<replay::Remark> m_remarked;  ///< at the moment that is shown
    Points m_followed;                       ///< at the last call of follow()
    bool m_isPaused = false;
    tooth::ToothView* m_beside = nullptr;
    glm::dmat4 m_sharedLook{1.0};  ///< of both cameras
};

}  // namespace ui::window
