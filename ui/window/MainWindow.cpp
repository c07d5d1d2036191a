// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/MainWindow.h"

#include <initializer_list>
#include <utility>

#include <QAction>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QIcon>
#include <QListView>
#include <QResizeEvent>
#include <QScreen>
#include <QStackedWidget>
#include <QTimer>

#include "ui/admin/AdminPage.h"
#include "ui/admin/PeoplePart.h"
#include "ui/admin/RosterPart.h"
#include "ui/console/Console.h"
#include "ui/devices/DevicesPage.h"
#include "ui/inside/SectionView.h"
#include "ui/inside/XrayPage.h"
#include "ui/kit/Actions.h"
#include "ui/kit/BusyOverlay.h"
#include "ui/kit/Page.h"
#include "ui/kit/Theme.h"
#include "ui/lessoneditor/LessonEditor.h"
#include "ui/people/AssignPage.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/people/LoginPage.h"
#include "ui/practice/HandControls.h"
#include "ui/practice/LessonStrip.h"
#include "ui/practice/SidePanel.h"
#include "ui/practice/StereoCard.h"
#include "ui/practice/ViewMenu.h"
#include "ui/presets/PresetsPage.h"
#include "ui/scoring/CommentsPanel.h"
#include "ui/scoring/ScorePage.h"
#include "ui/scoring/ScorePredictionPage.h"
#include "ui/settings/SettingsPage.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/LessonTexts.h"
#include "ui/tooth/ToothView.h"
#include "ui/toothchooser/ToothChooser.h"
#include "ui/window/ActionStates.h"
#include "ui/window/HelpOverlay.h"
#include "ui/window/KeyFilter.h"
#include "ui/window/PracticeRoom.h"

namespace ui::window {
namespace {

using kit::MessageBar;

/// The state of the session is read this often even while the view draws nothing.
constexpr int kSessionMs = 100;
constexpr QSize kFirstSize{1280, 800};
/// Every page is usable in this size. It fits a screen of 1280 x 800 that is enlarged by half.
constexpr QSize kSmallest{800, 460};
/// Title bar and borders. Their sizes are unknown before the window is shown.
constexpr QSize kAroundWindow{8, 40};

}  // namespace

MainWindow::MainWindow(core::session::UiChannels& links, QWidget* parent)
    : QMainWindow(parent), m_links(links), m_actions(new kit::Actions(this)),
      m_viewMenu(new practice::ViewMenu(*m_actions, this)), m_view(new tooth::ToothView(links)),
      m_pages(new QStackedWidget(this)), m_room(new PracticeRoom(*m_actions, *m_viewMenu, m_view, m_pages)),
      m_chooser(new toothchooser::ToothChooser(*m_actions, m_pages)),
      m_scorePage(new scoring::ScorePage(*m_actions, m_pages)),
      m_lessonsPage(new catalog::LessonsPage(*m_actions, m_pages)), m_login(new people::LoginPage(m_pages)),
      m_history(new people::HistoryPage(*m_actions, m_pages)), m_classes(new people::ClassPage(*m_actions, m_pages)),
      m_assign(new people::AssignPage(*m_actions, m_pages)), m_admin(new admin::AdminPage(*m_actions, m_pages)),
      m_editor(new lessoneditor::LessonEditor(*m_actions, m_pages)),
      m_prediction(new scoring::ScorePredictionPage(*m_actions, m_pages)),
      m_presets(new presets::PresetsPage(*m_actions, m_pages)),
      m_devicesPage(new devices::DevicesPage(*m_actions, m_pages)), m_xray(new inside::XrayPage(*m_actions, m_pages)),
      m_messages(new MessageBar(m_pages)), m_busy(new kit::BusyOverlay(m_pages)),
      m_help(new HelpOverlay(*m_actions, m_pages)),
      m_tour(new Tour(*m_actions, {*m_room, *m_lessonsPage, *m_classes, *m_admin}, m_pages)),
      m_stereoCard(new practice::StereoCard(m_room)), m_notices(*m_messages), m_commands(links, *m_messages),
      m_bur(m_commands, *m_actions, m_state)
{
    setWindowIcon(QIcon(QStringLiteral(":/ui/cusp.svg")));
    setMinimumSize(kSmallest);
    resize(firstSize(screen()->availableSize()));
    setAcceptDrops(true);
    setCentralWidget(m_pages);
    addPages();
    makeParts();
    m_settingsPage = new settings::SettingsPage(*m_actions, m_console->parameters(), m_pages);
    m_pages->addWidget(m_settingsPage);
    m_actions->burs.front()->setChecked(true);
    m_actions->bringHome->setVisible(false);
    m_actions->mouth->setVisible(m_view->isUsable());

    connectParts();
    connectActions();
    connectFileActions();
    connectPageActions();
    connectView();
    connectPages();
    new KeyFilter(*m_pages, *m_room,
                  {m_history, m_classes, m_assign, m_admin, m_presets, m_settingsPage, m_editor, m_prediction, m_login,
                   m_devicesPage},
                  this);
    auto* pulse = new QTimer(this);
    connect(pulse, &QTimer::timeout, m_practice.get(), &PracticeController::takeSession);
    pulse->start(kSessionMs);
    m_layout->restore();
    text::bindTranslation(this, [this] { retranslateUi(); });
    m_room->setHintVisible(m_view->isUsable());
    m_navigation->goToRoom();
}

MainWindow::~MainWindow()
{
    // The pages outlive the parts, which the slots of the window use.
    for (QObject* child : findChildren<QObject*>())
        child->disconnect(this);
}

QSize MainWindow::firstSize(const QSize& available)
{
    return kFirstSize.boundedTo(available - kAroundWindow).expandedTo(kSmallest);
}

void MainWindow::addPages()
{
    for (QWidget* page :
         std::initializer_list<QWidget*>{m_room, m_chooser, m_scorePage, m_xray, m_lessonsPage, m_editor, m_prediction,
                                         m_login, m_history, m_classes, m_assign, m_presets, m_admin, m_devicesPage})
        m_pages->addWidget(page);
}

void MainWindow::makeParts()
{
    m_layout = std::make_unique<WindowLayout>(*this, *m_room, *m_actions, *m_view);
    m_console = std::make_unique<ConsoleView>(*m_room, *m_actions);
    m_files = std::make_unique<FileDialogs>(*this, *m_messages);
    m_navigation = std::make_unique<Navigation>(Navigation::Pages{*m_pages, *m_room, *m_login, *m_lessonsPage,
                                                                  *m_editor, *m_classes, *m_assign, *m_admin,
                                                                  *m_scorePage, *m_history, *m_help},
                                                *m_actions, *m_messages, *m_tour, nullptr);
    m_unsaved =
        std::make_unique<UnsavedWork>(*this, m_state, *m_files, *m_actions, [this] { return m_hardness->isTrial(); });
    m_account = std::make_unique<AccountController>(*this, m_state, *m_login, *m_actions, *m_navigation, *m_unsaved);
    m_resume = std::make_unique<ResumeOffer>(*m_messages, *m_lessonsPage, *m_navigation, *m_unsaved);
    m_replay =
        std::make_unique<ReplayView>(m_state, *m_room, *m_actions, *m_view, *m_messages, *m_files, *m_navigation);
    m_exercise = std::make_unique<ExerciseView>(m_state, *m_room, *m_actions, *m_view, *m_replay, m_commands);
    m_infraction = std::make_unique<InfractionView>(m_state, *m_room, *m_actions, *m_view, m_bur);
    m_lesson = std::make_unique<LessonController>(m_state, *m_room, *m_actions, *m_viewMenu, *m_messages,
                                                  *m_lessonsPage, *m_navigation, m_bur, *m_exercise);
    m_notes = std::make_unique<AttemptNotes>(m_links, m_state, *m_actions, *m_viewMenu, m_console->watch(), *m_view,
                                             *m_navigation, *m_xray);
    m_practice = std::make_unique<PracticeController>(m_links, m_state, *m_room, *m_view, *m_viewMenu, m_bur, *m_replay,
                                                      *m_exercise, *m_lesson, *m_notes);
    m_hardness = std::make_unique<HardnessController>(m_state, *m_room, *m_presets, m_console->console(), *m_messages,
                                                      *m_files, *m_unsaved, m_commands);
    m_console->addParameters(*m_hardness, *m_view, m_room->panel().hand(), m_state, *m_exercise);
    m_editing =
        std::make_unique<LessonEditing>(m_state, *m_lessonsPage, *m_editor, *m_actions, *m_navigation, m_notices);
    m_unsaved->changes().add(m_admin->people());
    m_unsaved->changes().add(m_admin->roster());
    m_unsaved->changes().add(*m_presets);
    m_unsaved->changes().add(m_scorePage->talk());
    m_unsaved->changes().add(*m_editor);
}

void MainWindow::connectParts()
{
    connect(m_messages, &MessageBar::changed, this, &MainWindow::placeOverlays);
    connect(m_layout.get(), &WindowLayout::changed, this, &MainWindow::refresh);
    connect(m_console.get(), &ConsoleView::closed, this, &MainWindow::focusRoom);
    connect(m_console.get(), &ConsoleView::resized, this, &MainWindow::placeOverlays);
    connect(m_editing.get(), &LessonEditing::changed, this, &MainWindow::refresh);
    connect(m_navigation.get(), &Navigation::pageShown, this, &MainWindow::showPage);
    connect(m_navigation.get(), &Navigation::lessonsRequested, this, &MainWindow::lessonsRequested);

    connect(m_unsaved.get(), &UnsavedWork::foreignChangesLeft, m_editor, &lessoneditor::LessonEditor::closeDrafts);
    connect(m_unsaved.get(), &UnsavedWork::gradeRequested, this, [this] {
        m_navigation->goToRoom();
        emit gradeRequested();
    });
    connect(m_account.get(), &AccountController::changed, this, &MainWindow::refresh);

    connect(m_replay.get(), &ReplayView::changed, this, &MainWindow::refresh);
    connect(m_replay.get(), &ReplayView::stopRequested, this, &MainWindow::replayStopRequested);
    connect(m_exercise.get(), &ExerciseView::changed, this, &MainWindow::refresh);
    connect(m_infraction.get(), &InfractionView::changed, this, [this] {
        if (m_navigation->isInRoom())
            focusRoom();
        refresh();
    });
    connect(m_lesson.get(), &LessonController::changed, this, &MainWindow::refresh);
    connect(m_lesson.get(), &LessonController::gradeRequested, this, &MainWindow::gradeRequested);
    connect(m_lesson.get(), &LessonController::roomRequested, m_navigation.get(), &Navigation::goToRoom);
    connect(m_lesson.get(), &LessonController::radiographLocked, this, [this] {
        if (m_navigation->isAt(*m_xray))
            m_navigation->goToRoom();
    });
    connect(m_practice.get(), &PracticeController::changed, this, &MainWindow::refresh);
    connect(m_practice.get(), &PracticeController::frameTaken, m_hardness.get(), &HardnessController::follow);
}

void MainWindow::connectActions()
{
    const auto on = [this](QAction* action, auto what) { connect(action, &QAction::triggered, this, what); };
    on(m_actions->drill, [this](bool checked) { m_bur.switchDrill(checked); });
    for (int k = 0; k < m_actions->burs.size(); ++k)
        on(m_actions->burs[k], [this, k] { m_bur.chooseBur(k); });
    for (int k = 0; k < m_actions->handpieces.size(); ++k)
        on(m_actions->handpieces[k], [this, k] { m_bur.chooseHandpiece(k); });
    on(m_actions->bringHome, [this] { m_commands.send(core::servo::BringHome{}); });
    on(m_actions->turnRound, [this] { m_view->turnRound(); });
    on(m_actions->resetView, [this] { m_view->resetCamera(); });
    on(m_actions->undo, [this] { step(true); });
    on(m_actions->redo, [this] { step(false); });
    on(m_actions->reload, [this] { m_lesson->startAgain(m_commands, *m_unsaved); });
    on(m_actions->grade, [this] {
        if (m_state.isReplaying)
            m_replay->offerToStop(tr("This is a replay. Stop it to grade your own work."));
        else
            emit gradeRequested();
    });
    on(m_actions->history, [this](bool shown) {
        m_room->history().setVisible(shown);
        placeOverlays();
        if (shown)
            m_room->history().list().setFocus();
        else
            m_view->setFocus();
    });
    connect(&m_room->history(), &practice::HistoryPanel::momentRequested, this,
            [this](const core::session::GoTo& where) {
                if (m_infraction->isShown())
                    m_infraction->goOn();  // the tooth that the infraction is about changes now
                m_commands.send(where);
            });
    on(m_actions->turnSection, [this] { m_room->section().turn(); });
    on(m_actions->radiograph, [this] { toggleXray(); });
    connect(m_actions, &kit::Actions::expertMissing, this, [this] {
        if (m_navigation->isInRoom() && !m_busy->isWorking())
            showMessage(text::noExpertWords(m_state.lesson(), isExamRunning()));
    });
}

/// Undoes or redoes: a change in the editor, otherwise a cut.
void MainWindow::step(bool undo)
{
    if (m_navigation->isAt(*m_editor)) {
        if (undo)
            m_editor->undo();
        else
            m_editor->redo();
    } else if (!undo) {
        m_commands.send(core::session::Redo{});
    } else if (!m_infraction->takeBack()) {
        m_commands.send(core::session::Undo{});
    }
}

void MainWindow::connectFileActions()
{
    const auto on = [this](QAction* action, auto what) { connect(action, &QAction::triggered, this, what); };
    on(m_actions->openScan, [this] {
        m_files->open(m_actions->openScan->text(), FileDialogs::Kind::Scan,
                      [this](const QString& path) { m_unsaved->leaveWork([this, path] { emit scanChosen(path); }); });
    });
    on(m_actions->openRecording, [this] {
        m_files->open(m_actions->openRecording->text(), FileDialogs::Kind::Recording,
                      [this](const QString& path) { emit recordingOpenRequested(path); });
    });
    on(m_actions->saveRecording, [this] {
        if (m_navigation->isAt(*m_editor))
            m_editor->save();
        else
            m_unsaved->saveRecording();
    });
    on(m_actions->saveReference, [this] {
        m_files->save(m_actions->saveReference->text(), FileDialogs::Kind::Reference,
                      newFileName(FileDialogs::Kind::Reference),
                      [this](const QString& path) { emit referenceSaveRequested(path); });
    });
    on(m_actions->savePicture, [this] {
        m_files->savePicture(m_actions->savePicture->text(), newFileName(FileDialogs::Kind::Picture),
                             [this] { return m_view->picture(); });
    });
    connect(m_xray, &inside::XrayPage::saveRequested, this, [this] {
        m_files->savePicture(tr("Save the X-ray pictures"), newFileName(FileDialogs::Kind::Picture),
                             [this] { return m_xray->bothFilms(); });
    });
}

void MainWindow::connectPageActions()
{
    const auto on = [this](QAction* action, auto what) { connect(action, &QAction::triggered, this, what); };
    on(m_actions->lessons, [this] { m_navigation->openLessons(); });
    on(m_actions->chooseTooth, [this] { m_navigation->goTo(*m_chooser); });
    on(m_actions->mouth, [this] {
        const bool flatIsShown = !m_navigation->isAt(*m_chooser) || !m_chooser->isMouthShown();
        m_navigation->goTo(*m_chooser);
        m_chooser->showMouth(flatIsShown);
    });
    on(m_actions->presets, [this] {
        emit m_hardness->presetsRequested();
        m_navigation->goTo(*m_presets);
    });
    on(m_actions->devices, [this] { m_navigation->goTo(*m_devicesPage); });
    on(m_actions->settings, [this] {
        m_settingsPage->refresh();
        m_navigation->goTo(*m_settingsPage);
    });
    on(m_actions->school, [this] {
        m_navigation->goTo(*m_admin);
        m_admin->show(m_admin->part());
    });
    on(m_actions->attempts, [this] { emit m_navigation->attemptsRequested(); });
    on(m_actions->classes, [this] { emit m_navigation->classesRequested(); });
    on(m_actions->readAgain, [this] { readAgain(); });
    on(m_actions->search, [this] { search(); });
    on(m_actions->tour, [this] { beginTour(); });
    on(m_actions->help, [this] {
        m_help->setVisible(!m_help->isVisible());
        placeOverlays();
    });
    on(m_actions->back, [this] { goBack(); });
    on(m_actions->quit, [this] { close(); });
}

void MainWindow::connectPages()
{
    using catalog::LessonsPage;
    using people::LoginPage;
    connect(m_chooser, &toothchooser::ToothChooser::toothChosen, this, [this](int fdi) {
        m_navigation->goToRoom();
        m_unsaved->leaveWork([this, fdi] { emit toothChosen(fdi); });
    });
    connect(m_lessonsPage, &LessonsPage::lessonChosen, this, [this](const lessons::Lesson& lesson) {
        m_navigation->goToRoom();
        m_unsaved->leaveWork([this, lesson] { emit lessonChosen(lesson); });
    });
    connect(m_lessonsPage, &LessonsPage::examAsked, this,
            [this](const kit::ConfirmOverlay::Question& card) { m_unsaved->ask("examQuestion", card); });
    connect(m_editor, &lessoneditor::LessonEditor::lessonSaved, this, &MainWindow::lessonsRequested);
    connect(m_scorePage, &scoring::ScorePage::nextRequested, m_lessonsPage, &LessonsPage::startNext);
    connect(m_admin, &admin::AdminPage::partOpened, this, [this] { hideReadError(); });
    connect(m_classes, &people::ClassPage::peopleRequested, this, [this] {
        m_admin->show(admin::AdminPage::People);
        m_navigation->goTo(*m_admin);
    });
    connect(m_login, &LoginPage::leaveRequested, this, &MainWindow::goBack);
    HardnessController* const hardness = m_hardness.get();
    connect(hardness, &HardnessController::pageRequested, this, [this] { m_navigation->goTo(*m_presets); });
    connect(hardness, &HardnessController::feelChanged, m_settingsPage, &settings::SettingsPage::refresh);
}

void MainWindow::connectView()
{
    connect(m_room, &PracticeRoom::viewAreaChanged, this, &MainWindow::placeOverlays);
    connect(m_view, &tooth::ToothView::frameAdvanced, this, [this](const core::servo::ServoState& servo) {
        if (servo.touching)
            m_account->idleLock().touch();
        m_console->periods().take(servo);
        m_practice->takeFrame(servo);
    });
    connect(m_view, &tooth::ToothView::pushRefused, this, [this] {
        if (!std::exchange(m_knowsFarSide, true))
            showMessage(tr("You cannot drill from below: the bur is on the other side of the tooth. Turn the tooth "
                           "back, or press V."));
    });
    const auto apply = [this](const tooth::ViewSettings& settings) {
        m_view->setSettings(settings);
        if (m_replay->beside() != nullptr)
            m_replay->beside()->setSettings(settings);
        m_room->section().setColours(settings.look.palette);
        m_room->panel().setColours(settings.look.palette);
        m_room->history().setColours(settings.look.palette);
        m_chooser->setMovesLittle(settings.movesLittle);
    };
    connect(m_viewMenu, &practice::ViewMenu::chosen, this, apply);
    apply(m_viewMenu->settings());
    connect(m_viewMenu, &practice::ViewMenu::sideRequested, m_view, &tooth::ToothView::lookFrom);
    connect(m_viewMenu, &practice::ViewMenu::stereoPageRequested, this, [this] {
        m_stereoCard->open(m_viewMenu->settings().presentation, m_viewMenu->stereoWay());
        placeOverlays();
    });
    connect(m_stereoCard, &practice::StereoCard::changed, m_viewMenu, &practice::ViewMenu::setStereo);
    connect(m_stereoCard, &practice::StereoCard::done, this, [this] {
        m_stereoCard->hide();
        m_view->setFocus();
    });
}

/// Translates what the pages do not translate themselves.
void MainWindow::retranslateUi()
{
    m_lesson->setAids(m_state.aids);
    m_lesson->setUsedUp(m_state.isUsedUp);
    m_exercise->mark();
    m_account->retranslateUi();
    if (m_state.tooth == nullptr) {
        setWindowTitle(tr("Cusp"));
        return;
    }
    showTitle();
    if (m_navigation->isAt(*m_prediction))
        m_prediction->setWork(m_state.title());
    placeOverlays();
}

void MainWindow::showPage()
{
    if (m_navigation->isAt(*m_lessonsPage))
        m_editing->showUnsaved();
    m_bur.setInRoom(m_navigation->isInRoom(), m_infraction->isShown());
    if (m_navigation->isInRoom())
        focusRoom();
    refresh();
}

/// Gives the keyboard focus to the card or the tooth, unless the user types in the console: the rest of the command
/// would act as shortcuts.
void MainWindow::focusRoom()
{
    if (m_console->isTypedIn(focusWidget()))
        return;
    if (m_infraction->isShown())
        m_infraction->setFocus();
    else
        m_view->setFocus();
}

void MainWindow::goBack()
{
    if (m_navigation->isAtLogin()) {
        if (m_navigation->mayLeaveLogin())
            m_navigation->leaveLogin();
    } else if (m_tour->isVisible()) {
        m_tour->end();
    } else if (m_help->isVisible()) {
        m_help->hide();
        m_view->setFocus();
    } else if (m_console->isOpen()) {
        m_actions->console->trigger();
    } else if (!m_navigation->isInRoom()) {
        m_navigation->leavePage();
    } else {
        goBackInRoom();
    }
}

/// Closes the topmost card or panel, or stops the replay, or leaves the full screen.
void MainWindow::goBackInRoom()
{
    if (m_infraction->isShown())
        m_infraction->goOn();
    else if (m_stereoCard->isVisible())
        m_stereoCard->cancel();
    else if (m_room->history().isVisible())
        m_actions->history->trigger();
    else if (m_state.isReplaying)
        emit replayStopRequested();
    else if (m_messages->dismiss() || m_room->hideNotice() || m_console->hideWatch())
        return;
    else if (isFullScreen())
        m_actions->fullScreen->trigger();
}

void MainWindow::search()
{
    const auto* page = qobject_cast<kit::Page*>(m_navigation->current());
    if (page != nullptr && page->focusSearch())
        return;
    if (m_actions->lessons->isEnabled())
        m_actions->lessons->trigger();
    static_cast<void>(m_lessonsPage->focusSearch());
}

void MainWindow::toggleXray()
{
    if (m_navigation->isAt(*m_xray)) {
        m_navigation->goToRoom();
        return;
    }
    if (const core::terrain::Tooth* tooth = m_view->tooth()) {
        m_xray->setTooth(*tooth);
        m_navigation->goTo(*m_xray);
    }
}

/// Updates the actions and the places of cards and messages.
void MainWindow::refresh()
{
    const QList<const QWidget*> ofTheSchool{m_classes, m_history, m_admin, m_presets};
    WindowFacts facts;
    facts.isInRoom = m_navigation->isInRoom();
    facts.isAtXray = m_navigation->isAt(*m_xray);
    facts.isAtLessons = m_navigation->isAt(*m_lessonsPage);
    facts.isInEditor = m_navigation->isAt(*m_editor);
    facts.isSchoolPage = ofTheSchool.contains(m_navigation->current());
    facts.isAtLogin = m_navigation->isAtLogin();
    facts.mayLeaveLogin = m_navigation->mayLeaveLogin();
    facts.isBusy = m_busy->isWorking();
    facts.isViewUsable = m_view->isUsable();
    facts.isTrial = m_hardness->isTrial();
    facts.isBlindfolded = m_exercise->isBlindfolded();
    facts.mayEdit = m_editing->isAllowed();
    facts.canLead = m_canLead;
    facts.hasBeside = m_replay->beside() != nullptr;
    facts.canEditorUndo = m_editor->canUndo();
    facts.canEditorRedo = m_editor->canRedo();
    enableActions(*m_actions, *m_viewMenu, m_state, facts);
    m_room->lesson().setMayBeginAgain(m_state.isGraded && !m_state.isUsedUp);
    placeOverlays();
}

void MainWindow::placeOverlays()
{
    m_help->setGeometry(m_pages->rect());
    if (m_help->isVisible())
        m_help->raise();
    m_tour->setGeometry(m_pages->rect());
    const bool inRoom = m_navigation->isInRoom();
    const QRect area = inRoom ? m_room->viewArea() : m_pages->rect();
    m_stereoCard->move(kit::kSpace4, area.bottom() - kit::kSpace4 - m_stereoCard->height());
    m_console->placeIn(area);
    m_infraction->placeIn(area, m_room->burPlace());
    m_messages->placeIn(area, inRoom ? MessageBar::Place::OverTheView : MessageBar::Place::BesideTheTitle,
                        m_room->burPlace());
    // A message that stays must not cover the buttons that lead to other pages.
    const bool isAbove = m_messages->stays() && !inRoom && !m_navigation->isAtLogin();
    m_pages->setContentsMargins(0, isAbove ? m_messages->geometry().bottom() + 1 : 0, 0, 0);
    m_busy->placeIn(area);
    if (m_tour->isVisible())
        m_tour->raise();
}

void MainWindow::showTooth(std::shared_ptr<const core::terrain::ToothAnatomy> tooth, std::uint64_t generation,
                           const std::function<QStringList()>& notes, bool unitInDoubt)
{
    m_busy->done();
    m_room->hideNotice();
    m_room->section().setHeld({});
    m_infraction->hide();
    // The message that the first tooth failed stays while another one is shown in its place.
    if (!std::exchange(m_isStandIn, false))
        m_messages->withdraw(MessageBar::Topic::Tooth);
    m_state.tooth = std::move(tooth);
    if (!m_state.isReplaying && generation != m_state.ownGeneration) {
        m_state.ownGeneration = generation;
        m_unsaved->begin();
        m_room->history().setTooth(m_state.tooth);
    }
    m_practice->setTooth();
    m_view->setTooth(m_state.tooth, generation);
    const bool isAssigned = m_state.isAssigned();
    m_state.ideal = m_state.isReplaying ? m_replay->ideal()
                    : isAssigned        ? m_state.assignment->shownIdeal()
                                        : core::grading::idealCavity(*m_state.tooth);
    m_room->lesson().setVisible(isAssigned && !m_state.isReplaying &&
                                (m_state.assignment->lesson || core::terrain::hasDecay(*m_state.tooth)));
    m_view->setIdeal(m_state.ideal);
    m_lesson->showIdeal();
    m_exercise->begin();
    showTitle();
    m_chooser->setPresent(m_state.tooth->fdi);
    // A user who has opened another page since requesting the tooth, or has not requested one, stays there.
    const QWidget* const page = m_navigation->current();
    const bool wasAsked = std::exchange(m_askedFrom, nullptr) == page;
    if (m_navigation->isAtLogin())  // typing on the login page is not interrupted
        m_navigation->putRoomBehindLogin();
    else if (wasAsked || page == m_room || page == m_chooser || m_state.isReplaying)
        m_navigation->goToRoom();
    if (!notes || notes().isEmpty())
        return;
    std::function<void(const QString&)> chooseUnit;
    if (unitInDoubt)
        chooseUnit = [this](const QString& unit) { m_unsaved->leaveWork([this, unit] { emit scanUnitChosen(unit); }); };
    m_notices.showScanNotes(notes, chooseUnit);
}

void MainWindow::showTitle()
{
    const bool isReplaying = m_state.isReplaying;
    const QString& whose = m_replay->whose();
    const bool isSomebodys = isReplaying && !whose.isEmpty();
    const QString title = m_state.isAssigned() || isReplaying ? m_state.title() : text::toothTitle(*m_state.tooth);
    m_room->setTooth(title,
                     //: Beside the name of the tooth, where otherwise "lower left first molar" stands
                     m_isSelfDrilling && !isReplaying ? tr("The simulated handpiece is active")
                     : isSomebodys                    ? whose
                                                      : text::toothName(m_state.tooth->fdi));
    //: %1: a lesson; %2: a person and a date
    setWindowTitle(tr("%1 – Cusp").arg(isSomebodys ? tr("%1 – %2").arg(title, whose) : title));
}

void MainWindow::setAssignment(const lessons::Assignment& assignment)
{
    m_hardness->endTrial();
    m_lesson->begin(assignment);
}

void MainWindow::setHandpieces(const std::vector<core::settings::Handpiece>& atHand)
{
    m_bur.setHandpieces(atHand);
    refresh();
}

void MainWindow::offerHome(bool canLead)
{
    m_canLead = canLead;
    m_actions->bringHome->setVisible(canLead);
    refresh();
}

void MainWindow::beginTrial()
{
    m_hardness->beginTrial();
    refresh();
}

void MainWindow::showChannels(core::session::UiChannels& channels)
{
    m_practice->showChannels(channels);
}

void MainWindow::setReplaying(bool replaying, double lengthS, core::grading::IdealTop ideal,
                              std::optional<lessons::Lesson> lesson, const QString& whose)
{
    m_replay->setReplaying(replaying, lengthS, std::move(ideal), std::move(lesson), whose);
    if (replaying)
        m_hardness->endTrial();
    m_bur.forgetRequests();
    m_exercise->showHistory();
    refresh();
}

void MainWindow::showBeside(core::session::UiChannels& links,
                            const std::shared_ptr<const core::terrain::ToothAnatomy>& tooth, std::uint64_t generation,
                            const core::grading::IdealTop& ideal, const QString& name)
{
    m_busy->done();
    m_replay->showBeside(links, tooth, generation, ideal, name);
}

void MainWindow::askPrediction()
{
    m_busy->done();
    if (m_state.assignment)
        m_prediction->ask(m_state.title(), m_state.assignment->rubric);
    m_navigation->goTo(*m_prediction);
}

void MainWindow::showScore(const lessons::ScoreSheet& sheet, const QList<database::AttemptRecord>& history,
                           const std::optional<scoring::ScorePrediction>& expected,
                           const std::optional<scoring::ScoredWork>& scored)
{
    m_busy->done();
    m_state.isGraded = true;
    m_unsaved->setGraded();
    m_lesson->endExam();
    m_exercise->conclude();
    // Another tooth may be shown when the language changes.
    const lessons::Lesson* const lesson = m_state.lesson();
    m_scorePage->setScore(
        [title = lesson != nullptr ? lesson->title : lessons::LocalText(), isLesson = lesson != nullptr,
         tooth = m_state.tooth] {
            return isLesson ? text::said(title) : tooth != nullptr ? text::toothTitle(*tooth) : QString();
        },
        sheet, history, expected, scored);
    if (lesson != nullptr) {
        m_lessonsPage->takeScore(sheet.totalTenths, sheet.passed());
        m_scorePage->setNext(m_lessonsPage->next());
    }
    // After an exam there is nothing left to do in the room.
    m_navigation->setBehindScore(m_state.isExam() ? static_cast<QWidget&>(*m_lessonsPage) : *m_room);
    m_navigation->goTo(*m_scorePage);
}

void MainWindow::showOldScore(std::function<QString()> work, const lessons::ScoreSheet& sheet,
                              const QList<database::AttemptRecord>& history,
                              const std::optional<scoring::ScorePrediction>& expected,
                              const std::optional<scoring::ScoredWork>& scored)
{
    m_busy->done();
    m_account->setGuestPresent();
    m_scorePage->setScore(std::move(work), sheet, history, expected, scored);
    m_navigation->openOldScore(m_askedFrom);
}

void MainWindow::showOverLimit()
{
    m_notices.showOverLimit(m_actions->saveRecording->text(), [this] { m_unsaved->saveRecording(); });
}

void MainWindow::setHistorySource(practice::HistorySource source)
{
    m_room->history().setSource(std::move(source));
}

bool MainWindow::isInRoom() const
{
    return m_navigation->isInRoom() && !m_help->isVisible();
}

bool MainWindow::isBusy() const
{
    return m_busy->isWorking();
}

void MainWindow::showBusy(const QString& what)
{
    m_askedFrom = m_navigation->current();
    m_busy->work(what);
    refresh();
}

void MainWindow::stopBusy()
{
    m_busy->done();
    refresh();
}

void MainWindow::showError(const core::Error& error, text::FailedOperation failed, const QString& file)
{
    stopBusy();
    m_isStandIn = m_state.tooth == nullptr;
    m_notices.showError(error, failed, file);
}

void MainWindow::showSaved(const QString& path)
{
    m_notices.showRecordingSaved(path);
    m_unsaved->setSaved();
}

void MainWindow::showDatabaseSilent()
{
    if (!m_navigation->isAtLogin())  // the login page shows it itself
        m_notices.showDatabaseSilent();
}

void MainWindow::readAgain()
{
    hideReadError();
    if (m_navigation->isAt(*m_admin))
        m_admin->readAgain();
    else if (m_navigation->isAt(*m_history))
        m_history->readAgain();
    else if (m_navigation->isAt(*m_presets))
        emit m_hardness->presetsRequested();
    else if (m_navigation->isAt(*m_classes))
        m_classes->readAgain();
    else if (m_navigation->isAt(*m_lessonsPage))
        emit lessonsRequested();
}

void MainWindow::readAttemptsAgain()
{
    if (m_navigation->isAt(*m_lessonsPage) || m_navigation->isAt(*m_history))
        readAgain();
}

void MainWindow::openHome()
{
    const database::Role role = m_account->user().role();
    if (role == database::Role::Instructor) {
        m_actions->classes->trigger();
        m_navigation->openClasses();  // a tour that begins before the page is filled ends here
    } else if (role == database::Role::Admin)
        m_actions->school->trigger();
    else
        m_navigation->openLessons();
}

void MainWindow::setWho(const database::Login& who)
{
    if (who.person() != m_account->user().person())
        m_unsaved->changes().discard();
    const bool isAdmin = who.role() == database::Role::Admin;
    m_admin->people().setAdmin(isAdmin ? QString::fromStdString(who.uid()) : QString());
    m_classes->setMayEnter(isAdmin);
    m_account->setUser(who);
}

void MainWindow::leaveAll()
{
    if (m_actions->idealColours->isChecked())
        m_viewMenu->colourAgainstIdeal(false);
    m_navigation->forget();
    m_lessonsPage->setUnfinished({}, {});
    m_lessonsPage->forget();
    m_history->forget();
    m_classes->forget();
    m_assign->forget();
    m_console->console().forget();
    m_room->panel().hand().reset();
    for (const auto topic : {MessageBar::Topic::Tooth, MessageBar::Topic::ResumableAttempt, MessageBar::Topic::General,
                             MessageBar::Topic::Keeping, MessageBar::Topic::Journal, MessageBar::Topic::Preset,
                             MessageBar::Topic::School, MessageBar::Topic::Page})
        m_messages->withdraw(topic);
}

void MainWindow::beginTour()
{
    m_navigation->beginTour(m_account->user().role());
    placeOverlays();
}

QString MainWindow::newFileName(FileDialogs::Kind kind) const
{
    return FileDialogs::newFileName(m_state.tooth->name, kind);
}

void MainWindow::openFile(const QString& path)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == FileDialogs::suffixOf(FileDialogs::Kind::Recording))
        emit recordingOpenRequested(path);
    else if (FileDialogs::scanSuffixes().contains(suffix))
        m_unsaved->leaveWork([this, path] { emit scanChosen(path); });
    else
        m_notices.showWrongFile(path);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (m_mayClose || !m_unsaved->wouldLoseAnything()) {
        m_layout->saveGeometry();
        return;
    }
    event->ignore();
    const auto leave = [this] {
        m_mayClose = true;
        close();
        m_mayClose = false;  // another handler may have prevented it
    };
    m_unsaved->leaveGrades([this, leave] {
        m_unsaved->leaveWork([this, leave] { m_unsaved->leaveChanges(leave, m_account->absentUser()); });
    });
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    placeOverlays();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!FileDialogs::droppedFile(*event->mimeData()).isEmpty() && !m_busy->isWorking() && !m_navigation->isAtLogin())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    openFile(FileDialogs::droppedFile(*event->mimeData()));
}

}  // namespace ui::window
