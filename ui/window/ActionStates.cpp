// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ActionStates.h"

#include <QAction>

#include "ui/kit/Actions.h"
#include "ui/practice/ViewMenu.h"

namespace ui::window {
namespace {

using kit::Actions;

/// Conditions that several actions share.
struct Conditions
{
    bool isMine;     ///< the student's tooth is shown, and no other tooth is being loaded
    bool mayCut;     ///< isMine, and the tooth may be cut
    bool mayGoBack;  ///< isMine, and cuts may be undone, which an exam does not allow
};

Conditions conditionsOf(const PracticeState& state, const WindowFacts& facts)
{
    const bool isMine = state.tooth != nullptr && !facts.isBusy && !state.isReplaying;
    return {isMine, isMine && !state.isOver, isMine && !state.isExam()};
}

void enableHand(Actions& actions, const WindowFacts& facts, const Conditions& are)
{
    const bool mayCut = facts.isInRoom && are.mayCut;
    actions.drill->setEnabled(mayCut);
    for (QAction* bur : actions.burs)
        bur->setEnabled(mayCut && !Actions::isRefused(bur));
    actions.allBurs->setEnabled(mayCut);
    for (QAction* handpiece : actions.handpieces)
        handpiece->setEnabled(mayCut && handpiece->isVisible());
    actions.otherHand->setEnabled(facts.isInRoom);
    actions.bringHome->setEnabled(facts.isInRoom && are.isMine && actions.bringHome->isVisible());
}

void enableAids(Actions& actions, const practice::ViewMenu& viewMenu, const PracticeState& state,
                const WindowFacts& facts, const Conditions& are)
{
    const lessons::Aids& aids = state.aids;
    const bool isViewShown = facts.isInRoom && facts.isViewUsable;
    const bool seesIdeal = state.ideal != nullptr && aids.ideal;
    for (QAction* action : viewMenu.actions())
        action->setEnabled(isViewShown);
    const auto restrict = [](QAction* action, bool allowed) { action->setEnabled(action->isEnabled() && allowed); };
    restrict(actions.depthColours, aids.heatMap);
    restrict(actions.idealColours, aids.heatMap && seesIdeal);
    restrict(actions.mirror, aids.mirror);
    restrict(actions.burColour, !state.isReplaying && aids.burColour && seesIdeal);
    restrict(actions.fixture, are.isMine && aids.fixture && state.ideal != nullptr);
    actions.outline->setEnabled(isViewShown && seesIdeal && !state.isExam());
    actions.savePicture->setEnabled(isViewShown && state.tooth != nullptr);
    actions.panel->setEnabled(facts.isInRoom);
    // The section has no room while another attempt is shown beside.
    actions.section->setEnabled(facts.isInRoom && aids.section && !facts.hasBeside);
    actions.turnSection->setEnabled(facts.isInRoom && aids.section && actions.section->isChecked());
    actions.radiograph->setEnabled((facts.isInRoom || facts.isAtXray) && state.tooth != nullptr && !facts.isBusy &&
                                   aids.radiograph);
}

void enableWork(Actions& actions, const PracticeState& state, const WindowFacts& facts, const Conditions& are)
{
    const bool mayStep = facts.isInRoom && are.mayGoBack;
    actions.undo->setEnabled(facts.isInEditor ? facts.canEditorUndo : mayStep && state.session.undoSteps > 0);
    actions.redo->setEnabled(facts.isInEditor ? facts.canEditorRedo : mayStep && state.session.redoSteps > 0);
    actions.saveReference->setEnabled(facts.isInRoom && are.isMine && !state.isExamRunning());
    actions.reload->setEnabled((are.mayGoBack || (are.isMine && state.isOver)) && !state.isUsedUp);
    actions.grade->setEnabled(facts.isInRoom && state.tooth != nullptr && !facts.isBusy &&
                              (!facts.isTrial || state.isReplaying) && !state.isExamRefused);
    actions.saveRecording->setEnabled((are.isMine && !state.isExamRunning()) || facts.isInEditor);
    actions.history->setEnabled(mayStep && !facts.isBlindfolded);
    actions.console->setEnabled(facts.isInRoom);
}

void enableReplay(Actions& actions, const PracticeState& state, const WindowFacts& facts)
{
    for (QAction* action : {actions.pauseReplay, actions.stepBack, actions.stepOn, actions.replayBegin,
                            actions.replayEnd, actions.slower, actions.faster, actions.beside, actions.along}) {
        action->setVisible(state.isReplaying && (facts.canLead || action != actions.along));
        action->setEnabled(facts.isInRoom && state.isReplaying && !facts.isBusy);
    }
    // If there is no recording of the lesson's author, a simulated hand shows how to cut.
    const lessons::Lesson* const lesson = state.lesson();
    const bool hasExpert = lesson != nullptr && (lesson->expert || !lessons::isExercise(lesson->task));
    actions.expert->setVisible(hasExpert && !lesson->exam && !state.isExamRunning());
    actions.expert->setEnabled(facts.isInRoom && state.tooth != nullptr && !facts.isBusy);
}

void enablePages(Actions& actions, const WindowFacts& facts)
{
    for (QAction* action : {actions.lessons, actions.settings, actions.devices, actions.presets, actions.chooseTooth,
                            actions.openScan, actions.openRecording})
        action->setEnabled(!facts.isBusy);
    actions.mouth->setEnabled(!facts.isBusy && actions.mouth->isVisible());
    actions.search->setEnabled(true);
    actions.readAgain->setEnabled(facts.isSchoolPage);
    for (QAction* action : {actions.account, actions.lock, actions.attempts, actions.classes, actions.school,
                            actions.back, actions.help, actions.tour})
        action->setEnabled(true);
    actions.editLesson->setEnabled(facts.mayEdit && facts.isAtLessons);
}

void enableAtLogin(Actions& actions, bool mayLeave)
{
    for (const Actions::Group& group : actions.groups())
        for (QAction* action : group.actions) {
            const bool leaves = action == actions.back || action == actions.account || action == actions.lock;
            action->setEnabled(action == actions.fullScreen || action == actions.quit || (mayLeave && leaves));
        }
}

}  // namespace

void enableActions(kit::Actions& actions, const practice::ViewMenu& viewMenu, const PracticeState& state,
                   const WindowFacts& facts)
{
    const Conditions are = conditionsOf(state, facts);
    enableHand(actions, facts, are);
    enableAids(actions, viewMenu, state, facts, are);
    enableWork(actions, state, facts, are);
    enableReplay(actions, state, facts);
    enablePages(actions, facts);
    if (facts.isAtLogin)
        enableAtLogin(actions, facts.mayLeaveLogin);
}

}  // namespace ui::window
