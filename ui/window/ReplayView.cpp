// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ReplayView.h"

#include <QAction>
#include <QMenu>
#include <QToolButton>

#include "ui/kit/Actions.h"
#include "ui/practice/HistoryPanel.h"
#include "ui/practice/SidePanel.h"
#include "ui/replay/ReplayBar.h"
#include "ui/replay/TimeLine.h"
#include "ui/tooth/ToothView.h"
#include "ui/window/FileDialogs.h"
#include "ui/window/Navigation.h"
#include "ui/window/PracticeRoom.h"

namespace ui::window {

using kit::MessageBar;

ReplayView::ReplayView(PracticeState& state, PracticeRoom& room, kit::Actions& actions, tooth::ToothView& view,
                       kit::MessageBar& messages, FileDialogs& files, const Navigation& navigation)
    : QObject(&room), m_state(state), m_room(room), m_actions(actions), m_view(view), m_messages(messages),
      m_files(files), m_navigation(navigation)
{
    connectBar();
    connect(m_actions.beside, &QAction::triggered, this, [this](bool wanted) {
        m_actions.beside->setChecked(m_beside != nullptr);
        if (!wanted)
            emit besideCloseRequested();
        else if (m_actions.isGuest())
            offerBeside({});
        else
            emit besidesRequested(m_state.lesson() != nullptr ? m_state.lesson()->id : std::string(),
                                  m_state.tooth->name);
    });
    connect(m_actions.expert, &QAction::triggered, this, &ReplayView::expertRequested);
    connect(m_actions.along, &QAction::triggered, this, &ReplayView::leadRequested);
}

void ReplayView::connectBar()
{
    replay::ReplayBar& bar = m_room.replay();
    connect(&bar, &replay::ReplayBar::stopRequested, this, &ReplayView::stopRequested);
    connect(&bar, &replay::ReplayBar::speedChosen, this, &ReplayView::speedChosen);
    connect(&bar, &replay::ReplayBar::seekRequested, this, [this](double seconds) {
        m_messages.withdraw(MessageBar::Topic::Tooth);  // the message that the recording has ended
        emit seekRequested(seconds);
    });
    const auto on = [this](QAction* action, auto what) { connect(action, &QAction::triggered, this, what); };
    on(m_actions.pauseReplay, [this] { pause(!m_isPaused); });
    for (const bool onward : {false, true})
        on(onward ? m_actions.stepOn : m_actions.stepBack, [this, &bar, onward] {
            pause(true);
            bar.step(onward);
        });
    on(m_actions.replayBegin, [&bar] { bar.goToBegin(); });
    on(m_actions.replayEnd, [&bar] { bar.goToEnd(); });
    on(m_actions.slower, [&bar] { bar.changeSpeed(false); });
    on(m_actions.faster, [&bar] { bar.changeSpeed(true); });
}

void ReplayView::setReplaying(bool replaying, double lengthS, core::grading::IdealTop ideal,
                              std::optional<lessons::Lesson> lesson, const QString& whose)
{
    if (replaying && !m_state.isReplaying)
        m_state.workAtRest = m_state.ownWork();
    m_state.isReplaying = replaying;
    m_state.replayedLesson = std::move(lesson);
    m_ideal = std::move(ideal);
    m_whose = whose;
    m_room.panel().setLesson(m_state.lesson());
    m_course = {};
    showRemarks();
    m_actions.along->setChecked(false);
    m_room.replay().begin(lengthS);
    showPaused(false);
    m_room.setReplaying(replaying);
}

void ReplayView::setCourse(const replay::AttemptTimeline& course)
{
    std::vector<replay::Remark> remarks = std::move(m_course.remarks);
    m_course = course;
    m_course.remarks = std::move(remarks);
    showCourse();
    emit pointsChanged();
}

void ReplayView::setRemarks(std::vector<replay::Remark> remarks)
{
    if (!m_state.isReplaying)
        return;
    m_course.remarks = std::move(remarks);
    showCourse();
    showRemarks();
}

void ReplayView::showCourse()
{
    m_room.replay().setCourse(withoutSecrets(m_course));
}

/// Returns a timeline without the infractions while an exam is running. Otherwise a student could record the exam and
/// see its infractions in a replay.
replay::AttemptTimeline ReplayView::withoutSecrets(replay::AttemptTimeline course) const
{
    if (m_state.isExamRunning())
        course.infractions.clear();
    return course;
}

void ReplayView::follow()
{
    m_room.replay().setPosition(m_state.session.recordedS);
    if (m_navigation.isInRoom())
        emit shown(m_state.session.recordedS);
    if (Points now = points(); now != m_followed) {
        m_followed = std::move(now);
        emit pointsChanged();
    }
    showRemarks();
}

/// Shows text and places of the comments on the present moment.
void ReplayView::showRemarks()
{
    std::vector<replay::Remark> now = m_course.remarksAt(m_state.session.recordedS);
    if (now == m_remarked)
        return;
    m_remarked = std::move(now);
    QStringList words;
    std::vector<glm::dvec3> pins;
    for (const replay::Remark& remark : m_remarked) {
        words << replay::remarkWords(remark);
        if (remark.placeMm)
            pins.push_back(*remark.placeMm);
    }
    m_room.showRemark(words.join(u'\n'));
    m_view.setPins(std::move(pins));
}

void ReplayView::pause(bool paused)
{
    showPaused(paused);
    emit pauseRequested(paused);
}

void ReplayView::showPaused(bool paused)
{
    m_isPaused = paused;
    m_actions.showReplayPaused(paused);
}

void ReplayView::showEnd()
{
    showPaused(true);
    offerToStop(tr("The recording has ended."));
}

void ReplayView::showLeadEnd(bool pushed)
{
    m_actions.along->setChecked(false);
    m_messages.say({MessageBar::Kind::News,
                    pushed ? tr("You pushed against the guidance, so it stopped. Press A to start it again.")
                           : tr("The handpiece is no longer available, so the guidance stopped."),
                    {},
                    {},
                    {}});
}

void ReplayView::offerToStop(const QString& sentence)
{
    m_messages.say({MessageBar::Kind::News,
                    sentence,
                    {},
                    tr("Stop the replay"),
                    [this] { emit stopRequested(); },
                    MessageBar::Topic::Tooth});
}

void ReplayView::showBeside(core::session::UiChannels& links,
                            const std::shared_ptr<const core::terrain::ToothAnatomy>& tooth, std::uint64_t generation,
                            const core::grading::IdealTop& ideal, const QString& name)
{
    hideBeside();
    m_beside = new tooth::ToothView(links, &m_room);
    m_beside->setAccessibleName(name);
    m_beside->setSettings(m_view.settings());
    m_beside->setTooth(tooth, generation);
    m_beside->setIdeal(ideal);
    emit pointsChanged();
    m_room.setBeside(m_beside, name);
    m_room.setSectionVisible(false);
    connect(m_beside, &tooth::ToothView::frameAdvanced, this, &ReplayView::lookAlike);
    m_beside->lookAs(m_view.camera());
    m_sharedLook = m_beside->camera().view();
    m_actions.beside->setChecked(true);
    emit changed();
}

void ReplayView::setBesideCourse(const replay::AttemptTimeline& course)
{
    m_room.replay().setBeside(withoutSecrets(course));
    m_besideCourse = course;
    emit pointsChanged();
}

void ReplayView::hideBeside()
{
    if (m_beside == nullptr)
        return;
    m_room.setBeside(nullptr);
    delete std::exchange(m_beside, nullptr);
    m_besideCourse = {};
    m_room.replay().setBeside({});
    m_room.setSectionVisible(m_actions.section->isChecked());
    m_actions.beside->setChecked(false);
    emit changed();
    m_view.setFocus();
}

/// Turns both teeth the same way: if the user has turned one, turns the other.
void ReplayView::lookAlike()
{
    tooth::ToothView* turned = m_beside->camera().view() != m_sharedLook ? m_beside : &m_view;
    if (turned->camera().view() == m_sharedLook)
        return;
    m_sharedLook = turned->camera().view();
    (turned == &m_view ? m_beside : &m_view)->lookAs(turned->camera());
}

void ReplayView::offerBeside(const QList<MessageBar::Choice>& attempts)
{
    if (!m_state.isReplaying || !m_navigation.isInRoom())
        return;
    if (attempts.isEmpty()) {
        askForBeside();
        return;
    }
    auto* menu = new QMenu(&m_room);
    menu->setObjectName(QStringLiteral("besideMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const MessageBar::Choice& attempt : attempts)
        connect(menu->addAction(QString(attempt.text).replace(u'&', QStringLiteral("&&"))), &QAction::triggered, this,
                attempt.action);
    menu->addSeparator();
    connect(menu->addAction(tr("From a file …")), &QAction::triggered, this, &ReplayView::askForBeside);
    menu->popup(aboveBesideButton(*menu));
}

void ReplayView::askForBeside()
{
    m_files.open(m_actions.beside->text(), FileDialogs::Kind::Recording,
                 [this](const QString& path) { emit besideRequested(path); });
}

/// Returns the position for a menu above its button, because the button is at the lower edge of the screen.
QPoint ReplayView::aboveBesideButton(const QMenu& menu) const
{
    const QWidget* at = &m_room.replay();
    for (const auto* button : m_room.replay().findChildren<QToolButton*>())
        if (button->defaultAction() == m_actions.beside)
            at = button;
    return at->mapToGlobal(QPoint(0, -menu.sizeHint().height()));
}

ReplayView::Points ReplayView::points() const
{
    const auto pointsAt = [](const replay::AttemptTimeline& course, double seconds) {
        std::vector<tooth::PointMark> points;
        for (const replay::TouchPoint& point : course.points)
            points.push_back({point.placeMm, point.reachMm, point.touchedAtS && *point.touchedAtS <= seconds});
        return points;
    };
    const double recordedS = m_state.session.recordedS;
    const double share = m_course.lengthS > 0.0 ? recordedS / m_course.lengthS : 0.0;
    return {pointsAt(m_course, recordedS), pointsAt(m_besideCourse, share * m_besideCourse.lengthS)};
}

}  // namespace ui::window
