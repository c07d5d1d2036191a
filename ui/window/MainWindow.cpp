// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/MainWindow.h"

#include <cmath>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include <QAbstractButton>
#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QIcon>
#include <QListView>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QRandomGenerator>
#include <QScreen>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>

#include "core/bur/Bur.h"
#include "core/teeth/Block.h"
#include "lessons/LessonCatalog.h"
#include "lessons/PresetShelf.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/PeoplePart.h"
#include "ui/admin/RosterPart.h"
#include "ui/console/Console.h"
#include "ui/console/WatchPanel.h"
#include "ui/devices/DevicesPage.h"
#include "ui/inside/SectionView.h"
#include "ui/inside/XrayPage.h"
#include "ui/kit/Actions.h"
#include "ui/kit/AppSettings.h"
#include "ui/kit/BusyOverlay.h"
#include "ui/kit/FileDialog.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/StandardFolders.h"
#include "ui/kit/Theme.h"
#include "ui/lessoneditor/LessonEditor.h"
#include "ui/people/AssignPage.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/people/LoginPage.h"
#include "ui/practice/ExerciseCard.h"
#include "ui/practice/HandControls.h"
#include "ui/practice/InfractionCard.h"
#include "ui/practice/LessonStrip.h"
#include "ui/practice/Limit.h"
#include "ui/practice/SidePanel.h"
#include "ui/practice/StereoCard.h"
#include "ui/practice/ViewMenu.h"
#include "ui/presets/PresetsPage.h"
#include "ui/presets/TrialCard.h"
#include "ui/replay/ReplayBar.h"
#include "ui/replay/TimeLine.h"
#include "ui/scoring/CommentsPanel.h"
#include "ui/scoring/ScorePage.h"
#include "ui/scoring/ScorePredictionPage.h"
#include "ui/settings/SettingsPage.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/PresetTexts.h"
#include "ui/tooth/ToothView.h"
#include "ui/toothchooser/ToothChooser.h"
#include "ui/window/AccountMenu.h"
#include "ui/window/FileDialogs.h"
#include "ui/window/HelpOverlay.h"
#include "ui/window/IdleLock.h"
#include "ui/window/KeyFilter.h"
#include "ui/window/PracticeRoom.h"

namespace ui::window {
namespace {

/// How long the servo may take to follow a wish before its own word counts again.
constexpr qint64 kGuideEveryMs = 100;
constexpr qint64 kWishMs = 500;
/// The session's state is read this often even while the view does not paint.
constexpr double kSecondsPerMinute = 60.0;
constexpr int kSessionMs = 100;
constexpr int kQuestionIconPx = 36;
constexpr int kConsolePx = 260;
constexpr QSize kFirstSize{1280, 800};
/// Every page works in it. It fits a screen of 1280 x 800 that is enlarged by half.
constexpr QSize kSmallest{800, 460};
/// What a title bar and borders take. They are not known before the window is shown.
constexpr QSize kAroundWindow{8, 40};

const QString kGeometry = QStringLiteral("window/geometry");
const QString kPanel = QStringLiteral("window/panel");
const QString kSection = QStringLiteral("window/section");
const QString kLeftHanded = QStringLiteral("window/leftHanded");

/// The file a drag carries, empty when it carries anything else.
QString droppedFile(const QMimeData* data)
{
    const QList<QUrl> urls = data->urls();
    return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

/// The direction from a place to the nearest column that is to be cut, seen from above; nothing where nothing is.
std::optional<double> towardsIdeal(const core::terrain::ToothAnatomy& tooth, const std::vector<float>& ideal,
                                   const glm::dvec3& placeMm)
{
    std::optional<glm::dvec2> nearest;
    for (int j = 0; j < tooth.grid.side; ++j)
        for (int i = 0; i < tooth.grid.side; ++i) {
            const std::size_t k = tooth.grid.index(i, j);
            const glm::dvec2 way = tooth.grid.nodeMm(i, j) - glm::dvec2(placeMm);
            if (ideal[k] < tooth.top[k] && (!nearest || glm::dot(way, way) < glm::dot(*nearest, *nearest)))
                nearest = way;
        }
    return nearest ? std::optional(std::atan2(nearest->y, nearest->x)) : std::nullopt;
}

}  // namespace

MainWindow::MainWindow(core::session::UiChannels& links, QWidget* parent)
    : QMainWindow(parent), m_links(links), m_shown(&links), m_actions(new kit::Actions(this)),
      m_viewMenu(new practice::ViewMenu(*m_actions, this)), m_accountMenu(new AccountMenu(*m_actions, this)),
      m_view(new tooth::ToothView(links)), m_pages(new QStackedWidget(this)),
      m_room(new PracticeRoom(*m_actions, *m_viewMenu, m_view, m_pages)),
      m_chooser(new toothchooser::ToothChooser(*m_actions, m_pages)),
      m_scorePage(new scoring::ScorePage(*m_actions, m_pages)),
      m_lessonsPage(new catalog::LessonsPage(*m_actions, m_pages)), m_login(new people::LoginPage(m_pages)),
      m_history(new people::HistoryPage(*m_actions, m_pages)), m_classes(new people::ClassPage(*m_actions, m_pages)),
      m_assign(new people::AssignPage(*m_actions, m_pages)), m_admin(new admin::AdminPage(*m_actions, m_pages)),
      m_editor(new lessoneditor::LessonEditor(*m_actions, m_pages)),
      m_forecast(new scoring::ScorePredictionPage(*m_actions, m_pages)),
      m_presets(new presets::PresetsPage(*m_actions, m_pages)), m_trialCard(new presets::TrialCard(m_room)),
      m_watch(new console::WatchPanel(m_parameters, m_room)),
      m_console(new console::Console(m_parameters, *m_watch, m_room)),
      m_devicesPage(new devices::DevicesPage(*m_actions, m_pages)), m_xray(new inside::XrayPage(*m_actions, m_pages)),
      m_messages(new kit::MessageBar(m_pages)), m_busy(new kit::BusyOverlay(m_pages)),
      m_help(new HelpOverlay(*m_actions, m_pages)),
      m_tour(new Tour(*m_actions, {*m_room, *m_lessonsPage, *m_classes, *m_admin}, m_pages)),
      m_stereoCard(new practice::StereoCard(m_room)), m_infractionCard(new practice::InfractionCard(m_room)),
      m_exerciseCard(new practice::ExerciseCard(m_actions->grade, m_room)),
      m_files(new FileDialogs(*this, *m_messages)), m_idle(new IdleLock(IdleLock::steadyClock(), this)),
      m_clock([this] { return m_session.recordedS; })
{
    m_behindScore = m_room;
    m_behindHistory = m_room;
    setWindowIcon(QIcon(QStringLiteral(":/ui/cusp.svg")));
    setMinimumSize(kSmallest);
    resize(firstSize(screen()->availableSize()));
    setAcceptDrops(true);
    setCentralWidget(m_pages);
    connect(m_messages, &kit::MessageBar::changed, this, &MainWindow::placeOverlays);
    for (QWidget* page :
         {static_cast<QWidget*>(m_room), static_cast<QWidget*>(m_chooser), static_cast<QWidget*>(m_scorePage),
          static_cast<QWidget*>(m_xray), static_cast<QWidget*>(m_lessonsPage), static_cast<QWidget*>(m_editor),
          static_cast<QWidget*>(m_forecast), static_cast<QWidget*>(m_login), static_cast<QWidget*>(m_history),
          static_cast<QWidget*>(m_classes), static_cast<QWidget*>(m_assign), static_cast<QWidget*>(m_presets),
          static_cast<QWidget*>(m_admin), static_cast<QWidget*>(m_devicesPage)})
        m_pages->addWidget(page);
    registerParameters();
    m_settingsPage = new settings::SettingsPage(*m_actions, m_parameters, m_pages);
    m_pages->addWidget(m_settingsPage);
    m_actions->burs.front()->setChecked(true);
    m_actions->bringHome->setVisible(false);
    m_actions->mouth->setVisible(m_view->isUsable());

    connectActions();
    connectView();
    connectReplay();
    connectDoor();
    connectTour();
    connectPresets();
    m_unsaved.add(m_admin->people());
    m_unsaved.add(m_admin->roster());
    m_unsaved.add(*m_presets);
    m_unsaved.add(m_scorePage->talk());
    m_unsaved.add(*m_editor);
    connect(m_chooser, &toothchooser::ToothChooser::toothChosen, this, [this](int fdi) {
        goTo(m_room);
        leaveWork([this, fdi] { emit toothChosen(fdi); });
    });
    connect(m_lessonsPage, &catalog::LessonsPage::lessonChosen, this, [this](const lessons::Lesson& lesson) {
        goTo(m_room);
        leaveWork([this, lesson] { emit lessonChosen(lesson); });
    });
    connect(m_lessonsPage, &catalog::LessonsPage::examAsked, this,
            [this](const kit::ConfirmOverlay::Question& card) { ask("examQuestion", card); });
    connect(m_lessonsPage, &catalog::LessonsPage::resumeRequested, this, &MainWindow::resumeUnfinished);
    connect(m_lessonsPage, &catalog::LessonsPage::feedbackRequested, this, &MainWindow::feedbackRequested);
    connect(m_lessonsPage, &catalog::LessonsPage::discardRequested, this, &MainWindow::discardUnfinished);
    connect(m_lessonsPage, &catalog::LessonsPage::folderRequested, this, &MainWindow::lessonFolderRequested);
    connect(m_editor, &lessoneditor::LessonEditor::stepsChanged, this, &MainWindow::enableActions);
    connect(m_editor, &lessoneditor::LessonEditor::lessonSaved, this, &MainWindow::lessonsRequested);
    const auto workOn = [this] {
        m_room->section().setHeld({});
        if (std::exchange(m_infractionStopped, false))
            wishDrill(true);
        m_view->setFocus();
    };
    connect(m_infractionCard, &practice::InfractionCard::goOnRequested, this, workOn);
    connect(m_infractionCard, &practice::InfractionCard::takeBackRequested, this, [this, workOn] {
        emit takeBackRequested(m_infractionTick);
        workOn();
    });
    m_room->setExercise(m_exerciseCard);
    m_room->setTrial(m_trialCard);
    connect(m_exerciseCard, &practice::ExerciseCard::answered, this,
            [this](std::size_t pad, core::terrain::Material said) {
                send(core::session::AddNote{core::grading::answerNote(pad, said)});
            });
    connect(m_forecast, &scoring::ScorePredictionPage::answered, this, &MainWindow::forecastGiven);
    connect(m_scorePage, &scoring::ScorePage::momentRequested, this, &MainWindow::momentRequested);
    connect(m_scorePage, &scoring::ScorePage::nextRequested, m_lessonsPage, &catalog::LessonsPage::startNext);
    connect(&m_room->lesson(), &practice::LessonStrip::stepShown, this, &MainWindow::markExercise);
    connect(m_xray, &inside::XrayPage::saveRequested, this, [this] {
        m_files->savePicture(tr("Save the X-ray pictures"), newFileName(FileDialogs::Kind::Picture),
                             [this] { return m_xray->bothFilms(); });
    });

    auto* pulse = new QTimer(this);
    connect(pulse, &QTimer::timeout, this, &MainWindow::takeSession);
    pulse->start(kSessionMs);
    new KeyFilter(*m_pages, *m_room,
                  {m_history, m_classes, m_assign, m_admin, m_presets, m_settingsPage, m_editor, m_forecast, m_login,
                   m_devicesPage},
                  this);
    recallLayout();
    text::bindTranslation(this, [this] { retranslateUi(); });
    m_room->setHintVisible(m_view->isUsable());
    goTo(m_room);
}

/// What the pages cannot know themselves.
void MainWindow::retranslateUi()
{
    setAids(m_aids);
    setUsedUp(m_isUsedUp);
    markExercise();
    if (m_unreachable)
        tellUnreachable();
    if (m_tooth == nullptr) {
        setWindowTitle(tr("Cusp"));
        return;
    }
    sayTooth();
    if (m_pages->currentWidget() == m_forecast)
        m_forecast->setWork(workTitle());
    placeOverlays();
}

/// As it was left. What a lesson locks is not asked: it comes with the lesson.
void MainWindow::recallLayout()
{
    const QSettings kept = kit::memory();
    static_cast<void>(restoreGeometry(kept.value(kGeometry).toByteArray()));
    setWindowState(windowState().setFlag(Qt::WindowFullScreen, false));
    m_actions->panel->setChecked(kit::recalled(kept, kPanel, true));
    m_room->setPanelVisible(m_actions->panel->isChecked());
    m_actions->section->setChecked(kit::recalled(kept, kSection, false));
    m_room->setSectionVisible(m_actions->section->isChecked());
    m_actions->otherHand->setChecked(kit::recalled(kept, kLeftHanded, false));
    m_view->setLeftHanded(m_actions->otherHand->isChecked());
}

QSize MainWindow::firstSize(const QSize& available)
{
    return kFirstSize.boundedTo(available - kAroundWindow).expandedTo(kSmallest);
}

MainWindow::~MainWindow() = default;

void MainWindow::connectActions()
{
    const auto on = [this](QAction* action, auto what) { connect(action, &QAction::triggered, this, what); };
    on(m_actions->drill, [this](bool checked) {
        m_infractionStopped = false;
        wishDrill(checked);
    });
    for (int k = 0; k < m_actions->burs.size(); ++k)
        on(m_actions->burs[k], [this, k] { wishBur(k); });
    on(m_actions->fixture, [this] { emit fixtureRequested(m_actions->fixture->isChecked()); });
    for (int k = 0; k < m_actions->handpieces.size(); ++k)
        on(m_actions->handpieces[k], [this, k] { wishHandpiece(k); });
    connect(m_actions->otherHand, &QAction::toggled, this, [this](bool left) {
        m_view->setLeftHanded(left);
        kit::memory().setValue(kLeftHanded, left);
    });
    on(m_actions->bringHome, [this] { send(core::servo::BringHome{}); });
    on(m_actions->turnRound, [this] { m_view->turnRound(); });
    on(m_actions->resetView, [this] { m_view->resetCamera(); });
    on(m_actions->undo, [this] {
        if (m_pages->currentWidget() == m_editor)
            m_editor->undo();
        else if (!m_infractionCard->takeBack())
            send(core::session::Undo{});
    });
    on(m_actions->redo, [this] {
        if (m_pages->currentWidget() == m_editor)
            m_editor->redo();
        else
            send(core::session::Redo{});
    });
    on(m_actions->reload, [this] { startAgain(); });
    on(m_actions->grade, [this] {
        if (m_replaying)
            offerToStop(tr("This is a replay. Stop it to grade your own work."));
        else
            emit gradeRequested();
    });
    on(m_actions->lessons, [this] { openLessons(); });
    on(m_actions->chooseTooth, [this] { goTo(m_chooser); });
    on(m_actions->mouth, [this] {
        const bool flatIsShown = m_pages->currentWidget() != m_chooser || !m_chooser->isMouthShown();
        goTo(m_chooser);
        m_chooser->showMouth(flatIsShown);
    });
    on(m_actions->openScan, [this] {
        m_files->open(m_actions->openScan->text(), FileDialogs::Kind::Scan,
                      [this](const QString& path) { leaveWork([this, path] { emit scanChosen(path); }); });
    });
    on(m_actions->editLesson, [this] { editChosenLesson(); });
    on(m_actions->saveReference, [this] {
        m_files->save(m_actions->saveReference->text(), FileDialogs::Kind::Reference,
                      newFileName(FileDialogs::Kind::Reference),
                      [this](const QString& path) { emit referenceSaveRequested(path); });
    });
    on(m_actions->saveRecording, [this] {
        if (m_pages->currentWidget() == m_editor) {
            m_editor->save();
            return;
        }
        m_afterSaving = {};
        askToSave();
    });
    on(m_actions->openRecording, [this] {
        m_files->open(m_actions->openRecording->text(), FileDialogs::Kind::Recording,
                      [this](const QString& path) { emit recordingOpenRequested(path); });
    });
    on(m_actions->savePicture, [this] {
        m_files->savePicture(m_actions->savePicture->text(), newFileName(FileDialogs::Kind::Picture),
                             [this] { return m_view->picture(); });
    });
    on(m_actions->section, [this](bool visible) {
        m_room->setSectionVisible(visible);
        kit::memory().setValue(kSection, visible);
        enableActions();
    });
    on(m_actions->turnSection, [this] { m_room->section().turn(); });
    on(m_actions->radiograph, [this] { toggleXray(); });
    on(m_actions->search, [this] {
        const auto* page = qobject_cast<kit::Page*>(m_pages->currentWidget());
        if (page != nullptr && page->focusSearch())
            return;
        if (m_actions->lessons->isEnabled())
            m_actions->lessons->trigger();
        static_cast<void>(m_lessonsPage->focusSearch());
    });
    connect(m_actions, &kit::Actions::expertMissing, this, [this] {
        if (m_pages->currentWidget() == m_room && !m_busy->isWorking())
            showMessage(text::noExpertWords(lessonShown(), isExamRunning()));
    });
    on(m_actions->panel, [this](bool visible) {
        m_room->setPanelVisible(visible);
        kit::memory().setValue(kPanel, visible);
    });
    on(m_actions->fullScreen, [this](bool full) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, full)); });
    on(m_actions->help, [this] {
        m_help->setVisible(!m_help->isVisible());
        placeOverlays();
    });
    on(m_actions->back, [this] { goBack(); });
    on(m_actions->account, [this] { showAccount(); });
    on(m_actions->lock, [this] { changeAccount(); });
    connect(m_accountMenu, &AccountMenu::passwordRequested, this, [this] { changePassword(); });
    connect(m_login, &people::LoginPage::leaveRequested, this, &MainWindow::goBack);
    on(m_actions->attempts, [this] { emit attemptsRequested(); });
    on(m_actions->classes, [this] { emit classesRequested(); });
    on(m_actions->readAgain, [this] { readAgain(); });
    on(m_actions->quit, [this] { close(); });
}

/// What has a grade, and what leaves no mark on the tooth, begins as another attempt; anything else is put back, and
/// can be brought back.
void MainWindow::startAgain()
{
    const bool hasWork = m_exerciseCard->isVisibleTo(m_room) || ownWork() != core::terrain::PerMaterial{};
    if (m_examIsOver && !m_isGraded && hasWork) {
        goTo(m_room);
        showMessage(tr("This exam is over but not graded yet. Press G to grade it."));
    } else if (m_exerciseCard->isVisibleTo(m_room) || isExam()) {
        m_lessonsPage->begin(*m_assignment->lesson, [this] { emit attemptAgainRequested(); });
    } else if (m_isGraded) {
        leaveWork([this] { emit attemptAgainRequested(); });
    } else {
        goTo(m_room);
        if (!send(core::session::Reload{}))
            return;
        m_messages->say({kit::MessageBar::Kind::News, tr("The tooth was reset."), {}, tr("Restore my work"), [this] {
                             send(core::session::Undo{});
                         }});
    }
}

void MainWindow::showBegunAnew()
{
    goTo(m_room);
    showMessage(isExam()                              ? tr("Another attempt at the exam begins.")
                : m_exerciseCard->isVisibleTo(m_room) ? tr("The exercise starts again.")
                : lessonShown() == nullptr            ? tr("Another attempt begins.")
                                                      : tr("Another attempt at the lesson begins."));
}

void MainWindow::setUsedUp(bool usedUp)
{
    m_isUsedUp = usedUp;
    kit::Actions::setAllowed(m_actions->reload, !usedUp, text::usedUpWords());
    enableActions();
}

/// Practice pauses while another page is read, an exam does not. A graded lesson is over.
void MainWindow::runClock()
{
    const bool isOver = m_isGraded && m_assignment->lesson;  // free practice goes on after its grade
    const bool isWorking = !isOver && (isExam() || m_pages->currentWidget() == m_room);
    const bool timeIsOver = m_clock.advance(isWorking);
    if (isWorking)
        m_room->lesson().setTime(m_clock.workedS());
    if (timeIsOver)
        endTime();
}

/// The time of the lesson is over: an exam ends and is graded, practice may go on.
void MainWindow::endTime()
{
    if (!isExam()) {
        m_messages->say(
            {kit::MessageBar::Kind::News,
             tr("The time for this lesson is over. Continue as long as you like, or press G for the grade."),
             {},
             {},
             {},
             kit::MessageBar::Topic::Lesson});
        return;
    }
    endExam();
    // The message stays on every page until the user has closed it.
    m_messages->say([] {
        return kit::MessageBar::Message{
            kit::MessageBar::Kind::Warning, tr("The time for this exam is over: cutting is disabled."), {}, {}, {},
            kit::MessageBar::Topic::Tooth};
    });
    emit gradeRequested();
}

void MainWindow::resumeClock(double recordedS, double workedS)
{
    m_clock.resume(recordedS, workedS);
}

void MainWindow::connectDoor()
{
    using people::LoginPage;
    connect(m_idle, &IdleLock::expired, this, &MainWindow::lockIfIdle);
    connect(m_actions->school, &QAction::triggered, this, [this] {
        goTo(m_admin);
        m_admin->show(m_admin->part());
    });
    connect(m_admin, &admin::AdminPage::partOpened, this,
            [this] { m_messages->withdraw(kit::MessageBar::Topic::Page); });
    connect(m_classes, &people::ClassPage::peopleRequested, this, [this] {
        m_admin->show(admin::AdminPage::People);
        goTo(m_admin);
    });
    connect(m_login, &LoginPage::loginRequested, this, &MainWindow::loginRequested);
    connect(m_login, &LoginPage::codeRequested, this, &MainWindow::codeRequested);
    connect(m_login, &LoginPage::schoolRequested, this, &MainWindow::schoolRequested);
    connect(m_login, &LoginPage::guestRequested, this, &MainWindow::guestRequested);
    connect(m_login, &LoginPage::passwordChangeRequested, this, &MainWindow::passwordChangeRequested);
    connect(m_login, &LoginPage::againRequested, this, &MainWindow::openAgainRequested);
    connect(m_login, &LoginPage::restoreRequested, this, &MainWindow::restoreRequested);
    connect(m_scorePage, &scoring::ScorePage::keepRequested, this, &MainWindow::keepRequested);
    // The user's attempt is on the disk, and offered to them when they log in again.
    connect(m_login, &LoginPage::otherRequested, this, [this] { leaveUnsaved([this] { emit logoutRequested(); }); });
}

void MainWindow::connectTour()
{
    connect(m_actions->tour, &QAction::triggered, this, &MainWindow::beginTour);
    connect(m_tour, &Tour::pageRequested, this, [this](Tour::Where where) {
        QWidget* const page = tourPage(where);
        if (m_pages->currentWidget() == page)
            return;
        if (page == m_lessonsPage)
            emit lessonsRequested();
        else if (page == m_classes)
            emit classesRequested();
        goTo(page);
    });
    connect(m_tour, &Tour::ended, this, [this] {
        goTo(m_beforeTour != nullptr ? m_beforeTour : m_room);
        emit tourEnded();
    });
}

QWidget* MainWindow::tourPage(Tour::Where where) const
{
    switch (where) {
    case Tour::Where::Lessons:
        return m_lessonsPage;
    case Tour::Where::Classes:
        return m_classes;
    case Tour::Where::School:
        return m_admin;
    case Tour::Where::Room:
        break;
    }
    return m_room;
}

void MainWindow::beginTour()
{
    if (isAtDoor() || m_tour->isVisible())
        return;
    m_help->hide();
    m_beforeTour = m_pages->currentWidget();
    m_tour->begin(m_who.role());
    placeOverlays();
}

void MainWindow::setIdleLimit(std::chrono::milliseconds limit)
{
    m_idle->setLimit(limit);
}

void MainWindow::lockIfIdle()
{
    if (!m_who.isGuest() && (!isAtDoor() || m_mayLeaveDoor))
        askWho(people::LoginMode::Locked);
    else if (m_login->keeps())  // whoever logs in after so long is somebody else
        m_login->offerToKeep({});
    else if (m_who.isGuest())
        m_isGuestGone = true;
}

bool MainWindow::isAtDoor() const
{
    return m_pages->currentWidget() == m_login;
}

/// Below the name that was clicked.
void MainWindow::showAccount()
{
    const auto* button = m_pages->currentWidget()->findChild<QAbstractButton*>(QStringLiteral("accountButton"));
    if (m_who.isGuest() || isAtDoor() || button == nullptr)
        changeAccount();
    else
        m_accountMenu->popup(
            button->mapToGlobal(QPoint(button->width() - m_accountMenu->sizeHint().width(), button->height())));
}

/// Locks the window of the logged-in user, who can unlock it or switch user.
void MainWindow::changeAccount()
{
    if (isAtDoor() && m_who.isGuest())
        goBack();
    else if (m_who.isGuest() && m_isGraded && ownWork() == m_workGraded && m_pages->currentWidget() == m_scorePage)
        emit keepRequested();  // the guest logs in to save this grade
    else if (m_who.isGuest())
        // Who logs in begins with a clean table.
        leaveWork([this] {
            leaveUnsaved([this] {
                askLogin();
                m_mayLeaveDoor = true;
                enableActions();
            });
        });
    else
        askWho(people::LoginMode::Locked);
}

/// Who is in may leave it as it is.
void MainWindow::changePassword()
{
    askWho(people::LoginMode::OwnPassword);
    m_login->ask(people::LoginMode::OwnPassword, true);
    m_mayLeaveDoor = true;
    enableActions();
}

/// What stands over the window would go on working behind the door.
void MainWindow::closeAllOver()
{
    m_afterSaving = {};
    for (kit::ConfirmOverlay* question : findChildren<kit::ConfirmOverlay*>(QString(), Qt::FindDirectChildrenOnly)) {
        question->hide();
        question->setObjectName({});
        question->deleteLater();  // it may be its answer that led here
    }
    for (QWidget* one : findChildren<QWidget*>())
        if (one->isWindow() && one->isVisible())
            one->close();
}

void MainWindow::askWho(people::LoginMode door)
{
    closeAllOver();
    if (!isAtDoor())
        m_behindDoor = m_pages->currentWidget();
    m_mayLeaveDoor = false;
    m_login->setLockedBy(QString::fromStdString(m_who.username()), isExamRunning() && !m_examIsOver);
    m_login->offerToKeep({});
    m_login->ask(door);
    goTo(m_login);
}

void MainWindow::askLoginToKeep()
{
    askLogin();
    m_login->offerToKeep([this] { return workTitle(); }, !m_isGuestGone);
}

bool MainWindow::keepsOnLogin() const
{
    return m_login->keeps();
}

void MainWindow::setWho(const database::Login& who)
{
    if (who.person() != m_who.person())
        m_unsaved.discard();
    m_who = who;
    m_admin->people().setAdmin(who.role() == database::Role::Admin ? QString::fromStdString(who.uid()) : QString());
    m_actions->showAccount(QString::fromStdString(who.username()));
    m_actions->attempts->setVisible(!who.isGuest());
    m_actions->school->setVisible(who.role() == database::Role::Admin);
    m_classes->setMayEnter(who.role() == database::Role::Admin);
    m_actions->classes->setVisible(who.role() == database::Role::Instructor || who.role() == database::Role::Admin);
    m_actions->readAgain->setVisible(!who.isGuest());
    if (isAtDoor()) {
        m_mayLeaveDoor = true;
        goTo(m_behindDoor != nullptr ? m_behindDoor : m_room);
    }
}

void MainWindow::setMayEdit(bool may)
{
    m_mayEdit = may;
    m_actions->editLesson->setVisible(may);
    m_lessonsPage->setMayEdit(may);
    if (may && !m_recoveryFolder.isEmpty())
        m_editor->recover(lessons::teachersFolder(),
                          QStringLiteral("%1/unsaved-lessons-%2.json")
                              .arg(m_recoveryFolder,
                                   m_who.isGuest() ? QStringLiteral("guest") : QString::fromStdString(m_who.uid())));
    m_lessonsPage->setUnsaved(may ? m_editor->unsavedFiles() : QSet<QString>());
    enableActions();
}

const QWidget* MainWindow::page() const
{
    return isAtDoor() ? m_behindDoor : m_tour->isVisible() ? m_beforeTour : m_pages->currentWidget();
}

void MainWindow::openHistory()
{
    if (m_pages->currentWidget() != m_history)
        m_behindHistory = m_pages->currentWidget() == m_classes ? static_cast<QWidget*>(m_classes) : m_room;
    goTo(m_history);
}

void MainWindow::openClasses()
{
    goTo(m_classes);
}

void MainWindow::openAssign()
{
    goTo(m_assign);
}

void MainWindow::showOldScore(std::function<QString()> work, const lessons::ScoreSheet& sheet,
                              const QList<database::AttemptRecord>& history,
                              const std::optional<scoring::ScorePrediction>& expected,
                              const std::optional<scoring::ScoredWork>& scored)
{
    m_isGuestGone = false;
    m_busy->done();
    m_scorePage->setScore(std::move(work), sheet, history, expected, scored);
    m_behindScore = m_room;
    for (QWidget* list : std::initializer_list<QWidget*>{m_history, m_lessonsPage, m_classes})
        if (m_askedFrom == list || m_pages->currentWidget() == list)
            m_behindScore = list;
    goTo(m_scorePage);
}

void MainWindow::backToScore()
{
    goTo(m_scorePage);
}

void MainWindow::backToHistory()
{
    goTo(m_history);
}

void MainWindow::leaveAll()
{
    // What one lesson showed to one person is not for the next.
    if (m_actions->idealColours->isChecked())
        m_viewMenu->colourAgainstIdeal(false);
    m_behindDoor = m_room;
    m_behindScore = m_room;
    m_behindHistory = m_room;
    m_lessonsPage->setUnfinished({}, {});
    m_lessonsPage->forget();
    m_history->forget();
    m_classes->forget();
    m_assign->forget();
    m_console->forget();
    m_room->panel().hand().reset();
    for (const auto topic :
         {kit::MessageBar::Topic::Tooth, kit::MessageBar::Topic::ResumableAttempt, kit::MessageBar::Topic::General,
          kit::MessageBar::Topic::Keeping, kit::MessageBar::Topic::Journal, kit::MessageBar::Topic::Preset,
          kit::MessageBar::Topic::School, kit::MessageBar::Topic::Page})
        m_messages->withdraw(topic);
}

void MainWindow::refuseLogin(const core::Error& error)
{
    if (error.code == core::ErrorCode::NewPassword)
        m_login->ask(people::LoginMode::NewPassword);
    else if (error.code == core::ErrorCode::WrongLogin && m_login->door() == people::LoginMode::NewPassword)
        m_login->refuse([] { return tr("The one-time code is no longer valid. Ask an admin for a new one."); });
    else if (error.code == core::ErrorCode::OutOfRange)
        m_login->refuseNewPassword([error] { return text::loginFault(error); });
    else
        m_login->refuse([error] { return text::loginFault(error); });
}

void MainWindow::setOpening(bool isOpening)
{
    m_login->setOpening(isOpening);
}

void MainWindow::setUnreachable(const std::optional<core::Error>& error, const QString& where,
                                const QDateTime& backupMade)
{
    m_unreachable = error;
    m_where = where;
    tellUnreachable();
    m_login->offerBackup(backupMade, where);
}

void MainWindow::tellUnreachable()
{
    m_login->setUnreachable(m_unreachable ? text::errorText(*m_unreachable, text::FailedOperation::KeepingGrades) +
                                                u'\n' + m_where
                                          : QString());
}

void MainWindow::sayAtDoor(std::function<QString()> sentence)
{
    m_login->say(std::move(sentence));
}

void MainWindow::connectPresets()
{
    connect(m_actions->presets, &QAction::triggered, this, [this] {
        emit presetsRequested();
        goTo(m_presets);
    });
    using presets::PresetsPage;
    using presets::TrialCard;
    connectConsole();
    connect(m_presets, &PresetsPage::saveRequested, this, &MainWindow::presetSaveRequested);
    connect(m_presets, &PresetsPage::useRequested, this, &MainWindow::presetUseRequested);
    connect(m_presets, &PresetsPage::importRequested, this, [this] {
        m_files->open(tr("Import a hardness preset"), FileDialogs::Kind::Preset,
                      [this](const QString& path) { emit presetImportRequested(path); });
    });
    connect(m_presets, &PresetsPage::exportRequested, this, [this](const core::settings::FeelPreset& preset) {
        m_files->save(tr("Export the hardness preset"), FileDialogs::Kind::Preset,
                      QStringLiteral("%1-v%2.%3")
                          .arg(QString::fromStdString(preset.name).replace(u'/', u'-'))
                          .arg(preset.version)
                          .arg(FileDialogs::suffixOf(FileDialogs::Kind::Preset)),
                      [this, preset](const QString& path) { emit presetExportRequested(preset, path); });
    });
    connect(m_presets, &PresetsPage::tryRequested, this,
            [this](const core::settings::FeelPreset& base, const core::settings::FeelPreset& preset) {
                leaveWork([this, base, preset] {
                    m_blindTrial.reset();
                    m_triedPreset.emplace(base, preset);
                    emit presetTrialRequested(preset);
                });
            });
    connect(m_presets, &PresetsPage::retireRequested, this, &MainWindow::presetRetireRequested);
    connect(m_presets, &PresetsPage::compareRequested, this,
            [this](const core::settings::FeelPreset& first, const core::settings::FeelPreset& second, int trials) {
                leaveWork([this, first, second, trials] {
                    m_blindTrial.emplace(first, second, trials, QRandomGenerator::global()->generate64());
                    m_triedPreset.reset();
                    emit presetTrialRequested(first);
                });
            });
    connect(m_trialCard, &TrialCard::felt, this, [this](const core::settings::FeelPreset& preset) {
        m_feel = preset;
        emit presetFelt(preset);
    });
    connect(m_trialCard, &TrialCard::blockChosen, this, &MainWindow::trialBlockChosen);
    connect(m_trialCard, &TrialCard::freshBlockRequested, this, [this] { send(core::session::Reload{}); });
    connect(m_trialCard, &TrialCard::done, this, [this] {
        if (const auto tuned = m_trialCard->tuned())
            m_presets->setDraft(*tuned);
        emit presetsRequested();
        goTo(m_presets);
    });
    connect(m_trialCard, &TrialCard::csvRequested, this, [this](const QByteArray& csv) {
        m_files->saveComparison(tr("Save the comparison"), newFileName(FileDialogs::Kind::Table), csv);
    });
}

void MainWindow::registerParameters()
{
    console::registerFeel(
        m_parameters, [this] { return m_feel; }, [this] { return m_usualFeel; },
        [this](const core::settings::FeelPreset& next) { return feelByHand(next); });
    console::registerSwitch(m_parameters, "view.wet", m_actions->wetLook);
    console::registerSwitch(m_parameters, "view.bur_light", m_actions->burLight, true);
    console::registerSwitch(m_parameters, "view.neighbours", m_actions->neighbours);
    console::registerSwitch(m_parameters, "view.hand_place", m_actions->handPlace);
    console::registerSwitch(m_parameters, "view.every_eye", m_actions->distinctColours);
    console::registerSwitch(m_parameters, "view.less_motion", m_actions->reducedMotion);
    console::registerHand(
        m_parameters, m_view->hand(), [this](double mmPerS) { m_room->panel().hand().setFeed(mmPerS); },
        [this](double newtons) { m_view->setPushForce(newtons); });
    console::registerLive(
        m_parameters, [this] { return m_servo; }, m_periods,
        [this] {
            return console::Told{m_aids.depthGauge && !isBlindfolded(), !isBlindfolded()};
        });
    connect(m_watch, &console::WatchPanel::resized, this, &MainWindow::placeOverlays);
    connect(m_console, &console::Console::closeRequested, m_actions->console, &QAction::trigger);
    connect(m_actions->console, &QAction::triggered, this, [this] {
        if (m_console->isVisible()) {
            m_console->hide();
            focusRoom();
        } else {
            m_console->open();
        }
        placeOverlays();
    });
    connect(m_actions->devices, &QAction::triggered, this, [this] { goTo(m_devicesPage); });
    connect(m_actions->settings, &QAction::triggered, this, [this] {
        m_settingsPage->refresh();
        goTo(m_settingsPage);
    });
}

void MainWindow::showFeel(const core::settings::FeelPreset& now, const core::settings::FeelPreset& usual)
{
    m_feel = now;
    m_usualFeel = usual;
    m_settingsPage->refresh();
}

/// How the console keeps a preset, which is answered by showPresetKept() or showPresetFault(), and feels one.
void MainWindow::connectConsole()
{
    m_console->setPresets(
        [this](const QString& name) {
            core::settings::FeelPreset preset = m_feel;
            preset.name = name.toStdString();
            preset.version = 0;
            emit presetSaveRequested(preset);
            return QString();
        },
        [this](const QString& name) {
            const auto found = lessons::findPreset(m_presets->all(), name);
            if (!found)
                return tr("There is no hardness preset \"%1\". There are: %2.")
                    .arg(name, lessons::namesOf(m_presets->all()).join(QStringLiteral(", ")));
            const std::string refused = feelByHand(*found);
            //: %1 is a hardness preset
            return refused.empty() ? tr("It feels like %1 now.").arg(text::presetWords(*found))
                                   : QString::fromStdString(refused);
        },
        [this] { return lessons::namesOf(m_presets->all()); });
}

/// Answers why not, or nothing.
std::string MainWindow::feelByHand(const core::settings::FeelPreset& wanted)
{
    // What has all numbers of the usual one again is that one, whatever it was called in between.
    core::settings::FeelPreset next = m_usualFeel;
    for (const auto& field : core::settings::feelFields())
        next.*field.value = wanted.*field.value;
    if (!(next == m_usualFeel))
        next = wanted;
    if (isExamRunning())
        return tr("The hardness cannot be changed during an exam.").toStdString();
    if (m_replaying)
        return tr("A replay uses the recorded hardness.").toStdString();
    const bool isTried = m_trialCard->isVisibleTo(m_room);
    if (isTried && m_trialCard->isComparing())
        return tr("A blind comparison of two presets is running. Finish it first.").toStdString();
    // A lesson that brings its own hardness leaves the forces alone.
    core::settings::FeelPreset forces = next;
    for (const auto& field : core::settings::feelFields().subspan(0, core::settings::kCuttingFields))
        forces.*field.value = m_feel.*field.value;
    if (m_assignment && m_assignment->lesson && m_assignment->lesson->hardness && !(forces == next))
        return tr("This lesson sets its own hardness. Only the forces can be changed.").toStdString();
    m_feel = next;
    if (isTried) {
        if (m_trialCard->tuned())
            m_trialCard->tune(m_trialCard->base(), next);
        emit presetFelt(next);
    } else {
        emit feelRequested(next);
    }
    return {};
}

void MainWindow::setPresets(std::vector<lessons::ReadPreset> all, const core::settings::FeelPreset& inUse)
{
    m_presets->setPresets(std::move(all), inUse);
}

void MainWindow::showPresetKept(const core::settings::FeelPreset& preset, const QString& note)
{
    m_presets->select(preset);
    m_presets->setFault(note);
    const QString said = tr("The hardness preset was saved: %1.").arg(text::presetWords(preset));
    if (m_console->isVisible())
        m_console->say(note.isEmpty() ? said : said + u'\n' + note);
    else
        m_messages->say({kit::MessageBar::Kind::News, said, {}, {}, {}, kit::MessageBar::Topic::Preset});
}

void MainWindow::showPresetFault(const QString& sentence)
{
    m_messages->withdraw(kit::MessageBar::Topic::Preset);
    m_presets->setFault(sentence);
    if (m_console->isVisible() && !sentence.isEmpty())
        m_console->say(sentence);
}

void MainWindow::setMayKeepPresets(const database::Login& who, bool may)
{
    m_presets->setMayKeep(may);
    m_presets->setMayRetire(may && !who.isGuest());
}

void MainWindow::beginTrial()
{
    if (m_blindTrial)
        m_trialCard->compare(*m_blindTrial);
    else if (m_triedPreset)
        m_trialCard->tune(m_triedPreset->first, m_triedPreset->second);
    m_blindTrial.reset();
    m_triedPreset.reset();
    m_room->setHintVisible(false);
    enableActions();
    placeOverlays();
}

void MainWindow::editChosenLesson()
{
    if (isExamRunning()) {
        showMessage(tr("The lesson editor is not available during an exam, because it shows the ideal. Press G to "
                       "finish the exam, or start another lesson."));
        return;
    }
    const lessons::CatalogEntry* const entry = m_lessonsPage->chosen();
    if (entry == nullptr)  // nothing fits the search, and the page says so
        return;
    if (!entry->read.lesson) {
        showMessage(tr("This file is not a valid lesson, so it cannot be edited. Fix the listed errors first."));
        return;
    }
    if (entry->pack.isEmpty())
        editLesson(entry->read);
    else
        emit unpackRequested(entry->pack, QFileInfo(entry->read.file).fileName());
}

void MainWindow::openHome()
{
    if (m_who.role() == database::Role::Instructor) {
        m_actions->classes->trigger();
        goTo(m_classes);  // a tour that begins before it is filled ends here
    } else if (m_who.role() == database::Role::Admin)
        m_actions->school->trigger();
    else
        openLessons();
}

void MainWindow::openLessons()
{
    emit lessonsRequested();
    goTo(m_lessonsPage);
}

void MainWindow::editLesson(const lessons::ReadLesson& lesson)
{
    if (!m_mayEdit) {
        showMessage(
            tr("Only teachers can edit lessons: log in as a teacher. To practise the lesson, choose it in the list."));
        return;
    }
    m_editor->edit(lesson, lessons::teachersFolder());
    emit knownAttemptsRequested(*lesson.lesson);
    goTo(m_editor);
}

void MainWindow::setKnownAttempts(std::vector<lessoneditor::MeasuredAttempt> attempts)
{
    m_editor->setKnown(std::move(attempts));
}

void MainWindow::connectReplay()
{
    replay::ReplayBar& bar = m_room->replay();
    connect(&bar, &replay::ReplayBar::stopRequested, this, &MainWindow::replayStopRequested);
    connect(&bar, &replay::ReplayBar::speedChosen, this, &MainWindow::replaySpeedChosen);
    connect(&bar, &replay::ReplayBar::seekRequested, this, [this](double seconds) {
        m_messages->withdraw(kit::MessageBar::Topic::Tooth);  // it is at its end no longer
        emit seekRequested(seconds);
    });
    const auto hold = [this](bool paused) {
        showReplayPaused(paused);
        emit replayPauseRequested(paused);
    };
    const auto on = [this](QAction* action, auto what) { connect(action, &QAction::triggered, this, what); };
    on(m_actions->pauseReplay, [this, hold] { hold(!m_replayPaused); });
    for (const bool onward : {false, true})
        on(onward ? m_actions->stepOn : m_actions->stepBack, [&bar, hold, onward] {
            hold(true);
            bar.step(onward);
        });
    on(m_actions->replayBegin, [&bar] { bar.goToBegin(); });
    on(m_actions->replayEnd, [&bar] { bar.goToEnd(); });
    on(m_actions->slower, [&bar] { bar.changeSpeed(false); });
    on(m_actions->faster, [&bar] { bar.changeSpeed(true); });
    on(m_actions->history, [this](bool shown) {
        m_room->history().setVisible(shown);
        placeOverlays();
        if (shown)
            m_room->history().list().setFocus();
        else
            m_view->setFocus();
    });
    on(m_actions->beside, [this](bool wanted) {
        m_actions->beside->setChecked(m_beside != nullptr);
        if (!wanted)
            emit besideCloseRequested();
        else if (m_who.isGuest())
            offerBeside({});
        else
            emit besidesRequested(lessonShown() != nullptr ? lessonShown()->id : std::string(), m_tooth->name);
    });
    on(m_actions->expert, [this] { emit expertRequested(); });
    on(m_actions->along, [this](bool wanted) { emit leadRequested(wanted); });
    connect(&m_room->history(), &practice::HistoryPanel::momentRequested, this,
            [this](const core::session::GoTo& where) {
                if (m_infractionCard->isVisible())
                    m_infractionCard->goOn();  // it is about a tooth that is another now
                send(where);
            });
}

void MainWindow::setHistorySource(practice::HistorySource source)
{
    m_room->history().setSource(std::move(source));
}

void MainWindow::showBeside(core::session::UiChannels& links,
                            const std::shared_ptr<const core::terrain::ToothAnatomy>& tooth, std::uint64_t generation,
                            const core::grading::IdealTop& ideal, const QString& name)
{
    m_busy->done();
    hideBeside();
    m_beside = new tooth::ToothView(links, m_room);
    m_beside->setAccessibleName(name);
    m_beside->setSettings(m_view->settings());
    m_beside->setTooth(tooth, generation);
    m_beside->setIdeal(ideal);
    markExercise();
    m_room->setBeside(m_beside, name);
    m_room->setSectionVisible(false);
    connect(m_beside, &tooth::ToothView::frameAdvanced, this, &MainWindow::lookAlike);
    m_beside->lookAs(m_view->camera());
    m_sharedLook = m_beside->camera().view();
    m_actions->beside->setChecked(true);
    enableActions();
    placeOverlays();
}

void MainWindow::offerBeside(const QList<kit::MessageBar::Choice>& attempts)
{
    if (!m_replaying || m_pages->currentWidget() != m_room)
        return;
    const auto askForOne = [this] {
        m_files->open(m_actions->beside->text(), FileDialogs::Kind::Recording,
                      [this](const QString& path) { emit besideRequested(path); });
    };
    if (attempts.isEmpty()) {
        askForOne();
        return;
    }
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("besideMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const kit::MessageBar::Choice& attempt : attempts)
        connect(menu->addAction(QString(attempt.text).replace(u'&', QStringLiteral("&&"))), &QAction::triggered, this,
                attempt.action);
    menu->addSeparator();
    connect(menu->addAction(tr("From a file …")), &QAction::triggered, this, askForOne);
    // Above the button, which stands at the lower edge.
    const QWidget* at = &m_room->replay();
    for (const auto* button : m_room->replay().findChildren<QToolButton*>())
        if (button->defaultAction() == m_actions->beside)
            at = button;
    menu->popup(at->mapToGlobal(QPoint(0, -menu->sizeHint().height())));
}

void MainWindow::setBesideCourse(const replay::AttemptTimeline& course)
{
    m_room->replay().setBeside(asMayBeTold(course));
    m_besideCourse = course;
    markExercise();
}

void MainWindow::hideBeside()
{
    if (m_beside == nullptr)
        return;
    m_room->setBeside(nullptr);
    delete std::exchange(m_beside, nullptr);
    m_besideCourse = {};
    m_room->replay().setBeside({});
    m_room->setSectionVisible(m_actions->section->isChecked());
    m_actions->beside->setChecked(false);
    enableActions();
    m_view->setFocus();
}

/// Whichever was turned, the other follows.
void MainWindow::lookAlike()
{
    tooth::ToothView* turned = m_beside->camera().view() != m_sharedLook ? m_beside : m_view;
    if (turned->camera().view() == m_sharedLook)
        return;
    m_sharedLook = turned->camera().view();
    (turned == m_view ? m_beside : m_view)->lookAs(turned->camera());
}

void MainWindow::showLeadEnd(bool pushed)
{
    m_actions->along->setChecked(false);
    showMessage(pushed ? tr("You pushed against the guidance, so it stopped. Press A to start it again.")
                       : tr("The handpiece is no longer available, so the guidance stopped."));
}

bool MainWindow::isInRoom() const
{
    return m_pages->currentWidget() == m_room && !m_help->isVisible();
}

void MainWindow::offerHome(bool canLead)
{
    m_canLead = canLead;
    m_actions->bringHome->setVisible(canLead);
    enableActions();
}

void MainWindow::setAids(const lessons::Aids& aids)
{
    m_aids = aids;
    showIdeal();
    kit::Actions::setAllowed(m_actions->section, aids.section);
    kit::Actions::setAllowed(m_actions->turnSection, aids.section);
    kit::Actions::setAllowed(m_actions->radiograph, aids.radiograph);
    kit::Actions::setAllowed(m_actions->depthColours, aids.heatMap);
    kit::Actions::setAllowed(m_actions->mirror, aids.mirror);
    kit::Actions::setAllowed(m_actions->burColour, aids.burColour && aids.ideal);
    kit::Actions::setAllowed(m_actions->fixture, aids.fixture);
    m_actions->allowBurs(m_assignment && m_assignment->lesson ? m_assignment->lesson->burs
                                                              : std::vector<std::string>{});
    m_room->panel().setTold(aids.depthGauge, aids.depthGauge && aids.radiograph);
    m_room->section().setFiguresShown(aids.depthGauge);
    if (!aids.section) {
        m_actions->section->setChecked(false);
        m_room->setSectionVisible(false);
    }
    if (!aids.radiograph && m_pages->currentWidget() == m_xray)
        goTo(m_room);
    enableActions();
}

/// In section and colours, where the lesson has one and lets it be seen.
void MainWindow::showIdeal()
{
    lessons::Aids given = m_aids;
    given.ideal = m_aids.ideal && m_ideal != nullptr;
    kit::Actions::setAllowed(m_actions->idealColours, m_aids.heatMap && given.ideal,
                             m_aids.ideal ? tr("Only a tooth with decay has an ideal preparation.") : QString());
    kit::Actions::setAllowed(m_actions->outline, given.ideal && !isExam(),
                             isExam()       ? tr("The outline is not available in an exam.")
                             : m_aids.ideal ? tr("This tooth has no ideal preparation.")
                                            : QString());
    m_viewMenu->setAllowed(given);
    m_room->section().setIdeal(given.ideal ? m_ideal : nullptr);
}

/// The card and the marks of an exercise, where the tooth that is shown is one's.
void MainWindow::layExercise()
{
    const bool isThere = m_assignment && m_assignment->anatomy == m_tooth && m_assignment->exercise && !m_replaying &&
                         m_tooth != nullptr;
    if (isThere && m_exerciseGeneration != m_ownGeneration) {
        m_exerciseGeneration = m_ownGeneration;
        m_touched.reset();
        m_exerciseCard->begin(*m_assignment->exercise);
    }
    m_exerciseCard->setVisible(isThere);
    if (isThere)
        m_room->setHintVisible(false);
    markExercise();
    placeOverlays();
}

/// The points of the recordings that are played, here and beside, each as it was at the same share of its time.
std::pair<std::vector<tooth::PointMark>, std::vector<tooth::PointMark>> MainWindow::replayedPoints() const
{
    const auto pointsAt = [](const replay::AttemptTimeline& course, double seconds) {
        std::vector<tooth::PointMark> points;
        for (const replay::TouchPoint& point : course.points)
            points.push_back({point.placeMm, point.reachMm, point.touchedAtS && *point.touchedAtS <= seconds});
        return points;
    };
    const double share = m_replayCourse.lengthS > 0.0 ? m_session.recordedS / m_replayCourse.lengthS : 0.0;
    return {pointsAt(m_replayCourse, m_session.recordedS), pointsAt(m_besideCourse, share * m_besideCourse.lengthS)};
}

/// What of it is seen on the tooth: rings on points; or the pads' outlines alone, until they have been graded.
void MainWindow::markExercise()
{
    using namespace core::grading;
    tooth::ExerciseMarks marks;
    const bool isThere = m_exerciseCard->isVisibleTo(m_room);
    auto replayed = replayedPoints();
    marks.points = std::move(replayed.first);
    if (const auto* touch = isThere ? std::get_if<PointsToTouch>(&*m_assignment->exercise) : nullptr)
        for (std::size_t k = 0; k < touch->pointsMm.size(); ++k)
            marks.points.push_back({touch->pointsMm[k], touch->reachMm, m_touched && m_touched->atS.at(k)});
    if (m_assignment && m_assignment->anatomy == m_tooth && m_ideal != nullptr && !m_replaying && !isExam())
        m_room->lesson().markPlaces(marks, *m_tooth, *m_ideal);
    const bool isUnseen = isBlindfolded();
    if (isUnseen) {
        const glm::dvec2 half(0.5 * core::teeth::kPadWidthMm, 0.5 * core::teeth::kPadLengthMm);
        for (std::size_t pad = 0; pad < kPads; ++pad) {
            const glm::dvec2 middle(core::teeth::kPadX.at(pad), 0.0);
            marks.pads.push_back({practice::padName(pad), middle - half, middle + half});
        }
        marks.showsHeight = !m_actions->bringHome->isVisible();  // a device that leads a hand is felt by it
    }
    m_view->setExercise(marks);
    if (m_beside != nullptr)
        m_beside->setExercise(isUnseen ? marks : tooth::ExerciseMarks{std::move(replayed.second), {}, false});
    m_room->panel().setBlindfold(isUnseen);
    showHistory();
    enableActions();
}

void MainWindow::showHistory()
{
    m_room->history().setVisible(!m_replaying && !isBlindfolded() && !isExam() && m_actions->history->isChecked());
}

/// Tissues are to be told by feel, and have not been graded yet: neither here nor in a replay of such a block.
bool MainWindow::isBlindfolded() const
{
    const bool areUnnamed = m_assignment && m_assignment->exercise && m_exerciseGeneration == m_ownGeneration &&
                            std::holds_alternative<core::grading::PadsToName>(*m_assignment->exercise) &&
                            !m_exerciseCard->isConcluded();
    return areUnnamed && (m_exerciseCard->isVisibleTo(m_room) ||
                          (m_replaying && m_tooth != nullptr && m_tooth->name == m_assignment->anatomy->name));
}

void MainWindow::showPractised(const core::grading::Practised& practised)
{
    if (!m_exerciseCard->isVisibleTo(m_room))
        return;
    m_exerciseCard->setPractised(practised);
    if (const auto* touched = std::get_if<core::grading::Touched>(&practised);
        touched != nullptr && m_touched != *touched) {
        m_touched = *touched;
        markExercise();
    }
}

/// Where nothing is to be cut the drill is off to begin with, and afterwards as it was before.
void MainWindow::setDrillFor(lessons::Task task)
{
    const bool shallRest = task == lessons::Task::TouchPoints || task == lessons::Task::HoldForce;
    // What a rule has stopped was stopped for the work before only.
    m_drillWasOn = std::exchange(m_infractionStopped, false) || m_drillWasOn;
    if (shallRest) {
        m_drillWasOn = m_drillWasOn || m_burRests || m_actions->drill->isChecked();
        wishDrill(false);
    } else if (task == lessons::Task::TellLayers || m_drillWasOn || m_burRests) {
        m_drillWasOn = false;
        wishDrill(true);
    }
    m_burRests = false;
}

/// A bur turns only where it is watched: it stops while another page is read.
void MainWindow::restBur()
{
    const bool isAway = m_pages->currentWidget() != m_room;
    if (isAway && m_actions->drill->isChecked() && m_tooth != nullptr && !m_replaying) {
        m_burRests = true;
        wishDrill(false);
    } else if (!isAway && std::exchange(m_burRests, false) && !m_examIsOver) {
        if (m_infractionCard->isVisible())
            m_infractionStopped = true;
        else
            wishDrill(true);
    }
}

void MainWindow::toggleXray()
{
    if (m_pages->currentWidget() == m_xray) {
        goTo(pageBehind());
        return;
    }
    const core::terrain::Tooth* tooth = m_view->tooth();
    if (tooth == nullptr)
        return;
    m_xray->setTooth(*tooth);
    goTo(m_xray);
}

void MainWindow::connectView()
{
    connect(m_room, &PracticeRoom::viewAreaChanged, this, &MainWindow::placeOverlays);
    connect(m_view, &tooth::ToothView::frameAdvanced, this, &MainWindow::takeFrame);
    connect(m_view, &tooth::ToothView::pushRefused, this, [this] {
        if (!std::exchange(m_knowsTheFarSide, true))
            showMessage(tr("You cannot drill from below: the bur is on the other side of the tooth. Turn the tooth "
                           "back, or press V."));
    });
    const auto take = [this](const tooth::ViewSettings& settings) {
        m_view->setSettings(settings);
        if (m_beside != nullptr)
            m_beside->setSettings(settings);
        m_room->section().setColours(settings.look.palette);
        m_room->panel().setColours(settings.look.palette);
        m_room->history().setColours(settings.look.palette);
        m_chooser->setMovesLittle(settings.movesLittle);
    };
    connect(m_viewMenu, &practice::ViewMenu::chosen, this, take);
    take(m_viewMenu->settings());
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

void MainWindow::takeFrame(const core::servo::ServoState& servo)
{
    if (servo.touching)
        m_idle->touch();
    takeSession();
    m_servo = servo;
    m_periods.take(servo);
    const core::terrain::Tooth* tooth = m_view->tooth();
    core::imaging::DepthReading reading =
        tooth != nullptr && m_pulp && servo.tick > 0
            ? core::imaging::readDepth(*tooth, *m_pulp, servo.anchorMm, core::bur::burs()[servo.burIndex].headRadiusMm)
            : core::imaging::DepthReading{};
    // One depth, wherever it is told: that of the servo, who knows the flanks. Above the old surface there is none.
    reading.overTooth = servo.hasDepth && (servo.touching || reading.depthMm >= 0.0);
    reading.depthMm = servo.depthMm;
    if (!reading.overTooth && !servo.touching) {
        reading.dentinOverPulpMm.reset();
        reading.toPulpMm.reset();
    }
    m_room->panel().setFigures(servo, m_session, reading);
    m_room->section().follow(tooth, m_view->toothRevision(), servo, reading);
    guide(servo);
    if (m_trialCard->isVisible()) {
        const core::terrain::PerMaterial cut = ownWork();
        m_trialCard->follow(servo.burIndex, servo.handpieceIndex, std::accumulate(cut.begin(), cut.end(), 0.0));
    }
    if (m_exerciseCard->isVisible())
        m_exerciseCard->setServo(servo);
    if (servo.cutting && !m_hasCut) {
        m_hasCut = true;
        m_room->setHintVisible(false);
    }
    const auto mayAnswer = [](const Wish& wish, int said) {
        return said == wish.value || !wish.since.isValid() || wish.since.elapsed() > kWishMs;
    };
    // Before its first tick the servo has said nothing yet.
    if (servo.tick == 0)
        return;
    const bool isOn = servo.drillSwitchedOn || servo.drillOn;
    if (mayAnswer(m_drillWish, isOn ? 1 : 0) && m_actions->drill->isChecked() != isOn)
        m_actions->drill->setChecked(isOn);
    m_view->setDrillOn(servo.drillOn);
    if (servo.burIndex < m_actions->burs.size() && mayAnswer(m_burWish, servo.burIndex))
        m_actions->burs[servo.burIndex]->setChecked(true);
    if (servo.handpieceIndex < m_handpieces.size() && mayAnswer(m_handpieceWish, servo.handpieceIndex))
        if (const int shipped = m_handpieces[servo.handpieceIndex]; shipped >= 0)
            m_actions->handpieces[shipped]->setChecked(true);
}

/// How near the bur is to what is to be kept, and how far the work has come, ten times a second.
void MainWindow::guide(const core::servo::ServoState& servo)
{
    const core::terrain::Tooth* tooth = m_view->tooth();
    if (tooth == nullptr || m_ideal == nullptr || !m_aids.ideal || servo.tick == 0) {
        m_view->setBurTint({});
        m_room->panel().setGuide({}, {});
        return;
    }
    std::optional<double> marginMm;
    if (m_viewMenu->settings().showsMargin && servo.burIndex < core::bur::burs().size())
        marginMm =
            core::guidance::marginMm(*tooth->anatomy, *m_ideal, core::bur::burs()[servo.burIndex], servo.anchorMm);
    m_view->setBurTint(practice::limitColour(marginMm));
    if (m_sinceGuide.isValid() && m_sinceGuide.elapsed() < kGuideEveryMs)
        return;
    m_sinceGuide.start();
    m_room->panel().setGuide(marginMm, core::guidance::progressOf(*tooth->anatomy, *m_ideal, tooth->top));
}

void MainWindow::showChannels(core::session::UiChannels& channels)
{
    m_shown = &channels;
    m_view->showChannels(channels);
}

void MainWindow::takeSession()
{
    const core::session::SessionState& now = m_shown->session.latest();
    const bool moved = now.undoSteps != m_session.undoSteps || now.redoSteps != m_session.redoSteps;
    tellHarm(now);
    const auto marked = replayedPoints();
    m_session = now;
    if (m_replaying) {
        m_room->replay().setPosition(m_session.recordedS);
        if (m_pages->currentWidget() == m_room)
            emit replayShown(m_session.recordedS);
        if (replayedPoints() != marked)
            markExercise();
        showRemarks();
    } else if (m_session.toothGeneration == m_ownGeneration) {
        if (m_assignment) {
            runClock();
            m_room->lesson().follow(m_session.wholeMm3, m_session.removedMm3, m_room->panel().hand().isDeep(m_servo));
        }
        m_room->history().follow(m_session.historyVersion);
    }
    if (moved)
        enableActions();
    tellAids();
    tellRest();
    if (!m_replaying && m_tooth != nullptr)
        m_sights.look(m_view->camera(), m_ownGeneration, m_view->hand().isPushing());
}

/// Which aids are in use goes on the recording.
void MainWindow::tellAids()
{
    using namespace core::session;
    using namespace core::servo;
    if (m_replaying || m_tooth == nullptr)
        return;
    const auto inUse = [](bool used, Aid aid) { return static_cast<std::uint8_t>(used ? aid : 0); };
    const bool seesIdeal = m_ideal != nullptr && m_aids.ideal;
    const std::uint8_t aids = static_cast<std::uint8_t>(
        inUse(m_actions->section->isChecked(), kSectionAid) |
        inUse(m_aids.depthGauge && ((m_actions->panel->isChecked() && !(m_assignment && m_assignment->exercise)) ||
                                    m_watch->names().contains(QStringLiteral("live.depth"))),
              kDepthGaugeAid) |
        inUse(m_pages->currentWidget() == m_xray, kRadiographAid) |
        // What the lesson does not allow stays ticked for the next, and is not seen meanwhile.
        inUse(m_aids.heatMap && (m_actions->depthColours->isChecked() || m_actions->idealColours->isChecked()),
              kHeatMapAid) |
        inUse(m_aids.mirror && m_actions->mirror->isChecked(), kMirrorAid) |
        inUse(m_aids.burColour && m_ideal != nullptr && m_viewMenu->settings().showsMargin, kBurColourAid) |
        inUse(m_aids.fixture && m_actions->fixture->isChecked(), kFixtureAid) |
        inUse(seesIdeal && (m_actions->idealColours->isChecked() || m_actions->section->isChecked() ||
                            m_actions->outline->isChecked()),
              kIdealAid));
    if (m_aidsTold != std::pair(m_ownGeneration, aids) && m_links.commands.tryPush(SetAids{aids}))
        m_aidsTold = {m_ownGeneration, aids};
}

/// Time on another page, or away behind the lock, is none of the attempt's: that goes on the recording, and so score
/// card, history and criteria leave it out, as the lesson's clock does. An exam goes on.
void MainWindow::tellRest()
{
    if (m_replaying || m_tooth == nullptr)
        return;
    const bool rests = m_pages->currentWidget() != m_room && !isExam();
    const bool isTold = m_restTold.first == m_ownGeneration && m_restTold.second;
    if (rests != isTold &&
        m_links.commands.tryPush(core::session::AddNote{rests ? core::servo::kRestNote : core::servo::kWorkNote}))
        m_restTold = {m_ownGeneration, rests};
}

/// Told when it happens, not when a tooth is shown to which it has happened before.
void MainWindow::tellHarm(const core::session::SessionState& now)
{
    // A lesson says by its rules what is told, and an exam tells nothing, of no attempt.
    const bool inLesson = m_assignment && m_assignment->lesson && (!m_replaying || isExamRunning());
    if (now.toothGeneration != m_session.toothGeneration || inLesson)
        return;
    const auto isOpen = [](const core::session::SessionState& state) {
        return state.removedMm3.at(static_cast<std::size_t>(core::terrain::Material::Pulp)) > 0.0;
    };
    const QString toDo = m_replaying ? QString() : tr("You can undo the stroke.");
    if (now.perforated && !m_session.perforated)
        m_room->showNotice(tr("Tooth perforated"), toDo);
    else if (isOpen(now) && !isOpen(m_session))
        m_room->showNotice(tr("Pulp opened"), toDo);
    else if (!now.perforated && !isOpen(now))
        m_room->hideNotice();
}

bool MainWindow::send(core::session::SessionCommand command)
{
    return canSend(1) && m_links.commands.tryPush(std::move(command));
}

bool MainWindow::canSend(std::size_t commands)
{
    // Only this thread sends: the room in the queue does not get less meanwhile.
    if (m_links.commands.space() >= commands)
        return true;
    m_messages->say(
        {kit::MessageBar::Kind::Warning, tr("Cusp was still busy and did not do that. Try again."), {}, {}, {}});
    return false;
}

void MainWindow::wishDrill(bool on)
{
    if (!send(core::servo::SetDrill{on})) {
        m_actions->drill->setChecked(!on);
        return;
    }
    m_drillWish.value = on ? 1 : 0;
    m_drillWish.since.start();
}

void MainWindow::wishBur(int index)
{
    if (!send(core::servo::SetBur{static_cast<std::uint8_t>(index)}))
        return;
    m_burWish.value = index;
    m_burWish.since.start();
}

void MainWindow::takeInHand(std::optional<std::uint8_t> bur, std::optional<std::uint8_t> handpiece)
{
    if (bur)
        wishBur(*bur);
    if (handpiece && *handpiece < m_handpieces.size() && m_handpieces[*handpiece] >= 0)
        wishHandpiece(m_handpieces[*handpiece]);
}

void MainWindow::wishHandpiece(int shipped)
{
    const auto found = std::find(m_handpieces.begin(), m_handpieces.end(), shipped);
    const auto index = static_cast<std::uint8_t>(found - m_handpieces.begin());
    if (found == m_handpieces.end() || !send(core::servo::SetHandpiece{index}))
        return;
    m_handpieceWish.value = index;
    m_handpieceWish.since.start();
}

void MainWindow::setHandpieces(const std::vector<core::settings::Handpiece>& atHand)
{
    const auto shipped = core::settings::handpieces();
    m_handpieces.clear();
    for (const core::settings::Handpiece& handpiece : atHand) {
        const auto found = std::find(shipped.begin(), shipped.end(), handpiece);
        m_handpieces.push_back(found == shipped.end() ? -1 : static_cast<int>(found - shipped.begin()));
    }
    for (int k = 0; k < m_actions->handpieces.size(); ++k)
        m_actions->handpieces[k]->setVisible(std::find(m_handpieces.begin(), m_handpieces.end(), k) !=
                                             m_handpieces.end());
    m_handpieceWish = {};
    enableActions();
}

void MainWindow::goTo(QWidget* page)
{
    // An exam whose time is over, or a tooth that was being made, opens no door.
    if (isAtDoor() && page != m_login && !m_mayLeaveDoor) {
        m_behindDoor = page;
        return;
    }
    // What opens meanwhile is there when the tour has ended; the page it speaks of stays, and so does the keyboard.
    if (m_tour->isVisible() && page != m_login && page != tourPage(m_tour->where())) {
        m_beforeTour = page;
        return;
    }
    if (m_tour->isVisible() && page == m_pages->currentWidget())
        return;
    m_help->hide();
    if (page == m_login)
        m_tour->breakOff();
    if (page != m_room)
        m_messages->withdraw(kit::MessageBar::Topic::Lesson);
    if (page != m_pages->currentWidget())
        m_messages->withdraw(kit::MessageBar::Topic::Page);
    if (page == m_lessonsPage) {
        m_messages->withdraw(kit::MessageBar::Topic::ResumableAttempt);  // it has a card for it
        m_lessonsPage->setUnsaved(m_mayEdit ? m_editor->unsavedFiles() : QSet<QString>());
    }
    m_pages->setCurrentWidget(page);
    sayWayBack();
    restBur();
    if (page == m_room)
        focusRoom();
    enableActions();
    placeOverlays();
}

/// To what the keys are for in the practice room. Who types a command goes on typing: the rest of it would be taken
/// for keys of the tooth.
void MainWindow::focusRoom()
{
    if (m_console->isVisible() && m_console->isAncestorOf(focusWidget()))
        return;
    if (m_infractionCard->isVisible())
        m_infractionCard->setFocus();
    else
        m_view->setFocus();
}

/// Where Esc leads from the page that is shown.
QWidget* MainWindow::pageBehind() const
{
    const QWidget* const page = m_pages->currentWidget();
    if (page == m_editor)
        return m_lessonsPage;
    if (page == m_assign)
        return m_classes;
    if (page == m_scorePage)
        return m_behindScore;
    return page == m_history ? m_behindHistory : m_room;
}

/// What Esc, the arrow and the button of the page do is called by where they lead.
void MainWindow::sayWayBack()
{
    const QWidget* const behind = pageBehind();
    m_actions->showWayBack(behind == m_history       ? kit::Actions::Back::Attempts
                           : behind == m_classes     ? kit::Actions::Back::Class
                           : behind == m_lessonsPage ? kit::Actions::Back::Lessons
                                                     : kit::Actions::Back::Tooth);
}

/// Back within the page, or to what is behind it.
void MainWindow::leavePage()
{
    if (auto* page = qobject_cast<kit::Page*>(m_pages->currentWidget()); page != nullptr && page->stepBack())
        return;
    if (pageBehind() == m_lessonsPage)
        openLessons();
    else
        goTo(pageBehind());
}

void MainWindow::goBack()
{
    if (isAtDoor() && !m_mayLeaveDoor)
        return;
    if (m_tour->isVisible()) {
        m_tour->end();
    } else if (isAtDoor()) {
        goTo(m_behindDoor != nullptr ? m_behindDoor : m_room);
    } else if (m_help->isVisible()) {
        m_help->hide();
        m_view->setFocus();
    } else if (m_console->isVisible()) {
        m_actions->console->trigger();
    } else if (pageBehind() == m_lessonsPage || m_pages->currentWidget() != m_room) {
        leavePage();
    } else if (m_infractionCard->isVisible()) {
        m_infractionCard->goOn();
    } else if (m_stereoCard->isVisible()) {
        m_stereoCard->cancel();
    } else if (m_room->history().isVisible()) {
        m_actions->history->trigger();
    } else if (m_replaying) {
        emit replayStopRequested();
    } else if (m_messages->dismiss() || m_room->hideNotice()) {
        return;
    } else if (!m_watch->names().isEmpty()) {
        m_watch->forget({});
    } else if (isFullScreen()) {
        m_actions->fullScreen->trigger();
    }
}

void MainWindow::enableActions()
{
    const bool inRoom = m_pages->currentWidget() == m_room;
    const bool mine = m_tooth != nullptr && !m_busy->isWorking() && !m_replaying;
    const bool mayCut = mine && !m_examIsOver;
    const bool mayGoBack = mine && !isExam();  // as in a clinic
    m_actions->drill->setEnabled(inRoom && mayCut);
    for (QAction* bur : m_actions->burs)
        bur->setEnabled(inRoom && mayCut && !kit::Actions::isRefused(bur));
    m_actions->allBurs->setEnabled(inRoom && mayCut);
    for (QAction* handpiece : m_actions->handpieces)
        handpiece->setEnabled(inRoom && mayCut && handpiece->isVisible());
    m_actions->otherHand->setEnabled(inRoom);
    m_actions->bringHome->setEnabled(inRoom && mine && m_actions->bringHome->isVisible());
    for (QAction* action : m_viewMenu->actions())
        action->setEnabled(inRoom && m_view->isUsable());
    m_actions->depthColours->setEnabled(m_actions->depthColours->isEnabled() && m_aids.heatMap);
    m_actions->idealColours->setEnabled(m_actions->idealColours->isEnabled() && m_aids.heatMap && m_aids.ideal &&
                                        m_ideal != nullptr);
    m_actions->mirror->setEnabled(m_actions->mirror->isEnabled() && m_aids.mirror);
    const bool seesIdeal = m_ideal != nullptr && m_aids.ideal;
    m_actions->burColour->setEnabled(m_actions->burColour->isEnabled() && !m_replaying && m_aids.burColour &&
                                     seesIdeal);
    m_actions->fixture->setEnabled(m_actions->fixture->isEnabled() && mine && m_aids.fixture && m_ideal != nullptr);
    m_actions->outline->setEnabled(inRoom && m_view->isUsable() && seesIdeal && !isExam());
    m_actions->savePicture->setEnabled(inRoom && m_view->isUsable() && m_tooth != nullptr);
    m_actions->panel->setEnabled(inRoom);
    m_actions->section->setEnabled(inRoom && m_aids.section);
    m_actions->turnSection->setEnabled(inRoom && m_aids.section && m_actions->section->isChecked());
    m_actions->radiograph->setEnabled((inRoom || m_pages->currentWidget() == m_xray) && m_tooth != nullptr &&
                                      !m_busy->isWorking() && m_aids.radiograph);
    const bool inEditor = m_pages->currentWidget() == m_editor;
    m_actions->undo->setEnabled(inEditor ? m_editor->canUndo() : inRoom && mayGoBack && m_session.undoSteps > 0);
    m_actions->redo->setEnabled(inEditor ? m_editor->canRedo() : inRoom && mayGoBack && m_session.redoSteps > 0);
    m_actions->editLesson->setEnabled(m_mayEdit && m_pages->currentWidget() == m_lessonsPage);
    const QList<const QWidget*> ofTheSchool{m_classes, m_history, m_admin, m_presets};
    m_actions->readAgain->setEnabled(ofTheSchool.contains(m_pages->currentWidget()));
    m_actions->saveReference->setEnabled(inRoom && mine && !isExamRunning());
    m_actions->reload->setEnabled((mayGoBack || (mine && m_examIsOver)) && !m_isUsedUp);
    m_room->lesson().setMayBeginAgain(m_isGraded && !m_isUsedUp);
    const bool isTrial = !m_replaying && m_trialCard->isVisibleTo(m_room);
    m_actions->grade->setEnabled(inRoom && m_tooth != nullptr && !m_busy->isWorking() && !isTrial && !m_examIsRefused);
    m_actions->lessons->setEnabled(!m_busy->isWorking());
    m_actions->search->setEnabled(true);
    m_actions->console->setEnabled(inRoom);
    m_actions->settings->setEnabled(!m_busy->isWorking());
    m_actions->devices->setEnabled(!m_busy->isWorking());
    m_actions->presets->setEnabled(!m_busy->isWorking());
    m_actions->chooseTooth->setEnabled(!m_busy->isWorking());
    m_actions->mouth->setEnabled(!m_busy->isWorking() && m_actions->mouth->isVisible());
    m_actions->openScan->setEnabled(!m_busy->isWorking());
    m_actions->openRecording->setEnabled(!m_busy->isWorking());
    m_actions->saveRecording->setEnabled((mine && !isExamRunning()) || inEditor);
    m_actions->history->setEnabled(inRoom && mayGoBack && !isBlindfolded());
    for (QAction* action :
         {m_actions->pauseReplay, m_actions->stepBack, m_actions->stepOn, m_actions->replayBegin, m_actions->replayEnd,
          m_actions->slower, m_actions->faster, m_actions->beside, m_actions->along}) {
        action->setVisible(m_replaying && (m_canLead || action != m_actions->along));
        action->setEnabled(inRoom && m_replaying && !m_busy->isWorking());
    }
    // Where no recording lies with the lesson, a simulated hand shows it, if anything is to be cut.
    const lessons::Lesson* const lesson = lessonShown();
    const bool hasExpert = lesson != nullptr && (lesson->expert || !lessons::isExercise(lesson->task));
    m_actions->expert->setVisible(hasExpert && !lesson->exam && !isExamRunning());
    m_actions->expert->setEnabled(inRoom && m_tooth != nullptr && !m_busy->isWorking());
    if (m_beside != nullptr)  // there is no room for it
        m_actions->section->setEnabled(false);
    if (isAtDoor())
        for (const kit::Actions::Group& group : m_actions->groups())
            for (QAction* action : group.actions)
                action->setEnabled(action == m_actions->fullScreen || action == m_actions->quit ||
                                   (m_mayLeaveDoor && (action == m_actions->back || action == m_actions->account ||
                                                       action == m_actions->lock)));
    else
        for (QAction* action :
             {m_actions->account, m_actions->lock, m_actions->attempts, m_actions->classes, m_actions->school,
              m_actions->back, m_actions->help, m_actions->tour, m_actions->editLesson})
            action->setEnabled(action != m_actions->editLesson ||
                               (m_mayEdit && m_pages->currentWidget() == m_lessonsPage));
}

void MainWindow::placeOverlays()
{
    m_help->setGeometry(m_pages->rect());
    if (m_help->isVisible())
        m_help->raise();
    m_tour->setGeometry(m_pages->rect());
    const bool inRoom = m_pages->currentWidget() == m_room;
    const QRect area = inRoom ? m_room->viewArea() : m_pages->rect();
    m_stereoCard->move(kit::kSpace4, area.bottom() - kit::kSpace4 - m_stereoCard->height());
    m_console->setGeometry(area.x(), area.y(), area.width(), std::min(kConsolePx, area.height() / 2));
    const int belowConsole = m_console->isVisible() ? m_console->geometry().bottom() : area.top();
    m_watch->move(area.right() - kit::kSpace4 - m_watch->width(), belowConsole + kit::kSpace4);
    m_console->raise();
    m_infractionCard->placeIn(area, m_room->burPlace());
    m_messages->placeIn(area, inRoom ? kit::MessageBar::Place::OverTheView : kit::MessageBar::Place::BesideTheTitle,
                        m_room->burPlace());
    // What stays must not lie over the ways to other pages.
    const bool isAbove = m_messages->stays() && !inRoom && !isAtDoor();
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
    m_infractionCard->hide();
    // Where a tooth was refused before there was any, another one stands in for it: that stays said.
    if (!std::exchange(m_standsIn, false))
        m_messages->withdraw(kit::MessageBar::Topic::Tooth);
    m_tooth = std::move(tooth);
    if (!m_replaying && generation != m_ownGeneration) {
        m_ownGeneration = generation;
        m_savedWork = {};
        m_room->history().setTooth(m_tooth);
    }
    m_pulp.emplace(*m_tooth);
    m_view->setTooth(m_tooth, generation);
    const bool isAssigned = m_assignment && m_assignment->anatomy == m_tooth;
    m_ideal = m_replaying  ? m_replayIdeal
              : isAssigned ? m_assignment->shownIdeal()
                           : core::grading::idealCavity(*m_tooth);
    m_room->lesson().setVisible(isAssigned && !m_replaying &&
                                (m_assignment->lesson || core::terrain::hasDecay(*m_tooth)));
    m_view->setIdeal(m_ideal);
    showIdeal();
    layExercise();
    sayTooth();
    m_chooser->setPresent(m_tooth->fdi);
    // Who has gone to another page since the tooth was asked for, or has not asked for one, stays there.
    const QWidget* const page = m_pages->currentWidget();
    const bool wasAsked = std::exchange(m_askedFrom, nullptr) == page;
    if (isAtDoor())  // typing on the login page is not interrupted
        m_behindDoor = m_room;
    else if (wasAsked || page == m_room || page == m_chooser || m_replaying)
        goTo(m_room);
    if (notes && !notes().isEmpty())
        m_messages->say([this, notes, unitInDoubt] { return noteOfScan(notes(), unitInDoubt); });
}

kit::MessageBar::Message MainWindow::noteOfScan(const QStringList& notes, bool unitInDoubt)
{
    kit::MessageBar::Message message{kit::MessageBar::Kind::Warning, notes.front(), {}, {}, {},
                                     kit::MessageBar::Topic::Tooth};
    if (notes.size() > 1) {
        message.sentence = tr("%n note(s) about this scan", nullptr, static_cast<int>(notes.size()));
        message.detail = notes.join(u'\n');
    }
    if (unitInDoubt) {
        const auto choice = [this](const QString& words, const QString& unit) {
            return kit::MessageBar::Choice{words,
                                           [this, unit] { leaveWork([this, unit] { emit scanUnitChosen(unit); }); }};
        };
        message.actionText = tr("Another unit");
        message.choices = {choice(tr("Millimetres"), QStringLiteral("mm")),
                           choice(tr("Centimetres"), QStringLiteral("cm")), choice(tr("Metres"), QStringLiteral("m")),
                           kit::MessageBar::Choice{tr("Keep this unit"), {}}};
    }
    return message;
}

void MainWindow::sayTooth()
{
    const bool isAssigned = m_assignment && m_assignment->anatomy == m_tooth;
    const QString title = isAssigned || m_replaying ? workTitle() : text::toothTitle(*m_tooth);
    const bool selfDrilling = m_selfDrilling && !m_replaying;
    const bool isSomebodys = m_replaying && !m_replayWhose.isEmpty();
    m_room->setTooth(title,
                     //: Beside the name of the tooth, where otherwise "lower left first molar" stands
                     selfDrilling  ? tr("The simulated handpiece is active")
                     : isSomebodys ? m_replayWhose
                                   : text::toothName(m_tooth->fdi));
    //: %1: a lesson; %2: a person and a date
    setWindowTitle(tr("%1 – Cusp").arg(isSomebodys ? tr("%1 – %2").arg(title, m_replayWhose) : title));
}

void MainWindow::showBusy(const QString& what)
{
    m_askedFrom = m_pages->currentWidget();
    m_busy->work(what);
    enableActions();
    placeOverlays();
}

void MainWindow::showError(const core::Error& error, text::FailedOperation failed, const QString& file)
{
    const bool ofTooth = failed == text::FailedOperation::OpeningScan || failed == text::FailedOperation::MakingTooth ||
                         failed == text::FailedOperation::OpeningRecording;
    tellError(error, failed, file,
              ofTooth ? kit::MessageBar::Topic::Tooth
              : failed == text::FailedOperation::KeepingAttempt || failed == text::FailedOperation::KeepingExam
                  ? kit::MessageBar::Topic::Journal
              : failed != text::FailedOperation::ReadingSchool ? kit::MessageBar::Topic::General
              : error.code == core::ErrorCode::ConnectionLost  ? kit::MessageBar::Topic::School
                                                               : kit::MessageBar::Topic::Page);
}

void MainWindow::showNotKept(const core::Error& error)
{
    forgetNotKept();
    tellError(error, text::FailedOperation::KeepingGrade, {}, kit::MessageBar::Topic::Keeping);
}

void MainWindow::setUnkeptGrades(int count)
{
    m_unkeptGrades = count;
}

void MainWindow::forgetNotKept()
{
    m_messages->withdraw(kit::MessageBar::Topic::Keeping);
}

void MainWindow::showUnanswered()
{
    if (isAtDoor())
        return;  // which tells of it itself
    m_messages->withdraw(kit::MessageBar::Topic::School);
    m_messages->say([] {
        kit::MessageBar::Message message{
            kit::MessageBar::Kind::Warning,
            tr("The school's database does not answer yet. You can continue drilling; your "
               "request is completed when it answers."),
            {},
            {},
            {}};
        message.topic = kit::MessageBar::Topic::School;
        return message;
    });
}

void MainWindow::forgetUnanswered()
{
    m_messages->withdraw(kit::MessageBar::Topic::School);
}

void MainWindow::readAgain()
{
    m_messages->withdraw(kit::MessageBar::Topic::Page);
    const QWidget* const page = m_pages->currentWidget();
    if (page == m_admin)
        m_admin->readAgain();
    else if (page == m_history)
        m_history->readAgain();
    else if (page == m_presets)
        emit presetsRequested();
    else if (page == m_classes)
        m_classes->readAgain();
    else if (page == m_lessonsPage)
        emit lessonsRequested();
}

void MainWindow::readAttemptsAgain()
{
    if (m_pages->currentWidget() == m_lessonsPage || m_pages->currentWidget() == m_history)
        readAgain();
}

void MainWindow::forgetUnread()
{
    m_messages->withdraw(kit::MessageBar::Topic::Page);
}

void MainWindow::forgetAttemptNotKept()
{
    m_messages->withdraw(kit::MessageBar::Topic::Journal);
}

void MainWindow::tellError(const core::Error& error, text::FailedOperation failed, const QString& file,
                           kit::MessageBar::Topic topic)
{
    m_busy->done();
    enableActions();
    m_standsIn = m_tooth == nullptr;
    const QString exact = QString::fromStdString(error.detail);
    qWarning("%s", qPrintable(exact));
    const QString name = QFileInfo(file).fileName();
    // Its teacher can mend it: the key is named, as on the page of lessons.
    const QString detail =
        failed == text::FailedOperation::OpeningLesson && !name.isEmpty() ? name + QStringLiteral(": ") + exact : name;
    m_messages->say([=] {
        return kit::MessageBar::Message{
            kit::MessageBar::Kind::Error, text::errorText(error, failed), detail, {}, {}, topic, exact};
    });
}

bool MainWindow::isBusy() const
{
    return m_busy->isWorking();
}

void MainWindow::stopBusy()
{
    m_busy->done();
    enableActions();
}

void MainWindow::showWarning(const QString& sentence)
{
    m_messages->say({kit::MessageBar::Kind::Warning, sentence, {}, {}, {}});
}

void MainWindow::showMessage(const QString& sentence)
{
    m_messages->say({kit::MessageBar::Kind::News, sentence, {}, {}, {}});
}

void MainWindow::showUndoable(const QString& sentence, const std::function<void()>& undo)
{
    m_messages->say({kit::MessageBar::Kind::News, sentence, {}, tr("Undo"), undo});
}

void MainWindow::offerUnfinished(const std::function<QString()>& tooth, const QDateTime& begun, bool isExam)
{
    m_isUnfinishedExam = isExam;
    m_lessonsPage->setUnfinished(tooth, begun);
    m_offerUnfinished = [this, tooth, begun] {
        kit::MessageBar::Message offer;
        offer.kind = kit::MessageBar::Kind::Warning;
        offer.topic = kit::MessageBar::Topic::ResumableAttempt;
        //: %1: "Tooth 36", "Practice block: line"; %2: a time of today, or a day and a time
        offer.sentence = tr("%1: an attempt of %2 was not finished.").arg(tooth(), text::shortWhen(begun));
        offer.actionText = tr("Resume");
        offer.action = [this] { resumeUnfinished(); };
        offer.declining = {tr("Discard"), [this] { discardUnfinished(); }};
        return offer;
    };
    tellUnfinished();
}

/// The page of lessons has a card for it.
void MainWindow::tellUnfinished()
{
    m_messages->withdraw(kit::MessageBar::Topic::ResumableAttempt);
    if (m_pages->currentWidget() != m_lessonsPage)
        m_messages->say(m_offerUnfinished);
}

void MainWindow::resumeUnfinished()
{
    goTo(m_room);
    leaveWork([this] {
        forgetUnfinished();
        emit resumeRequested();
    });
}

void MainWindow::discardUnfinished()
{
    // A double click is meant for one: where another was waiting, it has its place by then.
    if (m_sinceDiscard.isValid() && !m_sinceDiscard.hasExpired(2 * QApplication::doubleClickInterval())) {
        tellUnfinished();
        return;
    }
    const auto discard = [this] {
        m_sinceDiscard.start();
        forgetUnfinished();
        emit discardRequested();
    };
    if (!m_isUnfinishedExam) {
        discard();
        return;
    }
    tellUnfinished();  // who thinks better of it finds it there
    ask("unfinishedQuestion", {tr("This exam would be discarded without a score."),
                               tr("It still counts as an attempt. You can restore it right afterwards."),
                               tr("&Continue it"), [this] { resumeUnfinished(); }, discard});
}

void MainWindow::forgetUnfinished()
{
    m_messages->withdraw(kit::MessageBar::Topic::ResumableAttempt);
    m_lessonsPage->setUnfinished({}, {});
}

void MainWindow::offerToBringBack(const std::function<void()>& bringBack)
{
    m_messages->say([bringBack] {
        // It stays until it is closed.
        return kit::MessageBar::Message{kit::MessageBar::Kind::Warning,
                                        tr("The attempt was discarded; it is kept for seven days."),
                                        {},
                                        tr("Restore it"),
                                        bringBack};
    });
}

void MainWindow::showScore(const lessons::ScoreSheet& sheet, const QList<database::AttemptRecord>& history,
                           const std::optional<scoring::ScorePrediction>& expected,
                           const std::optional<scoring::ScoredWork>& scored)
{
    m_busy->done();
    m_isGraded = true;
    m_workGraded = ownWork();
    endExam();
    if (m_exerciseCard->isVisibleTo(m_room)) {
        m_exerciseCard->conclude();
        markExercise();
    }
    // What lies on the table may be another by the time the language is.
    const lessons::Lesson* const lesson = lessonShown();
    m_scorePage->setScore(
        [title = lesson != nullptr ? lesson->title : lessons::LocalText(), isLesson = lesson != nullptr,
         tooth = m_tooth] {
            return isLesson ? text::said(title) : tooth != nullptr ? text::toothTitle(*tooth) : QString();
        },
        sheet, history, expected, scored);
    if (lesson != nullptr) {
        m_lessonsPage->takeScore(sheet.totalTenths, sheet.passed());
        m_scorePage->setNext(m_lessonsPage->next());
    }
    // Behind an exam there is nothing left to do at its tooth.
    m_behindScore = isExam() ? static_cast<QWidget*>(m_lessonsPage) : m_room;
    goTo(m_scorePage);
}

void MainWindow::showWorkKept()
{
    m_savedWork = m_workGraded;
}

void MainWindow::showOverLimit()
{
    m_messages->say({kit::MessageBar::Kind::Warning,
                     tr("You had no attempts left at this lesson, so this grade is not saved."),
                     tr("You can save your work as a recording."), m_actions->saveRecording->text(),
                     [this] { askToSave(); }, kit::MessageBar::Topic::Tooth});
}

void MainWindow::tellInfraction(const core::grading::Infraction& infraction, bool canTakeBack)
{
    m_infractionTick = infraction.tick;
    if (m_infractionCard->isHidden())
        m_infractionStopped = m_actions->drill->isChecked();
    wishDrill(false);
    // A bur that ran in the air has done nothing to be looked at or taken back.
    const bool didHarm = infraction.breach != core::grading::RuleViolation::BurInAir;
    if (didHarm)
        m_room->section().setHeld(infraction.placeMm);
    if (infraction.breach == core::grading::RuleViolation::RidgeCut)
        m_room->section().showAlong(0.0);
    // The card says that the section shows what is to be cut: the plane goes through the nearest of it.
    if (infraction.breach == core::grading::RuleViolation::WrongPlace && m_tooth && m_ideal)
        if (const auto towards = towardsIdeal(*m_tooth, *m_ideal, infraction.placeMm))
            m_room->section().showAlong(*towards);
    // A bur that was left running may be noticed while another page is read: the card waits for who comes back.
    if (didHarm && m_aids.section && !m_actions->section->isChecked()) {
        m_actions->section->setChecked(true);
        m_room->setSectionVisible(true);
        enableActions();
    }
    m_infractionCard->tell(infraction, canTakeBack && didHarm);
    if (m_pages->currentWidget() == m_room)
        focusRoom();
    m_room->setHintVisible(false);
    placeOverlays();
}

void MainWindow::askForecast()
{
    m_busy->done();
    if (m_assignment)
        m_forecast->ask(workTitle(), m_assignment->rubric);
    goTo(m_forecast);
}

/// Of the work on the table, or of the attempt that is played; null: none.
const lessons::Lesson* MainWindow::lessonShown() const
{
    if (m_replaying)
        return m_replayLesson ? &*m_replayLesson : nullptr;
    return m_assignment && m_assignment->lesson ? &*m_assignment->lesson : nullptr;
}

/// The lesson, or the tooth that is practised on.
QString MainWindow::workTitle() const
{
    if (const lessons::Lesson* lesson = lessonShown())
        return text::said(lesson->title);
    return m_tooth != nullptr ? text::toothTitle(*m_tooth) : QString();
}

void MainWindow::setAssignment(const lessons::Assignment& assignment)
{
    const bool isRepeated = m_assignment && lessons::isSameLesson(*m_assignment, assignment);
    m_assignment = assignment;
    m_trialCard->hide();
    m_isGraded = false;
    m_examIsOver = false;
    m_examIsRefused = false;
    m_clock.begin(assignment.lesson ? assignment.lesson->minutes * kSecondsPerMinute : 0.0);
    m_messages->withdraw(kit::MessageBar::Topic::Lesson);
    setUsedUp(false);
    setAids(assignment.lesson ? assignment.lesson->aids : lessons::Aids{});
    m_room->panel().setLesson(lessonShown());
    m_actions->fixture->setChecked(false);
    m_lessonsPage->setPresent(assignment.lesson ? assignment.lesson->id : std::string());
    m_room->panel().hand().begin(m_aids.depthStop && !assignment.exercise, lessons::depthToCutMm(assignment));
    setDrillFor(assignment.lesson ? assignment.lesson->task : lessons::Task::RemoveDecay);
    m_viewMenu->showNeighbours(assignment.neighbours != nullptr);
    if (!isRepeated)
        m_viewMenu->outlineIdeal(lessons::beginsWithOutline(assignment));
    showHistory();
    if (!assignment.lesson) {
        m_room->lesson().setPractice();
        return;
    }
    // It begins as it is meant to, and not with what the one before had open.
    m_actions->section->setChecked(false);
    m_room->setSectionVisible(false);
    m_viewMenu->colourAgainstIdeal(assignment.lesson->task == lessons::Task::TraceShape);
    m_room->lesson().setLesson(*assignment.lesson);
    if (!assignment.lesson->burs.empty())
        if (const auto bur = core::bur::findBur(assignment.lesson->burs.front()))
            wishBur(static_cast<int>(*bur));
}

void MainWindow::setLessons(std::vector<lessons::CatalogEntry> entries,
                            std::map<std::string, catalog::Standing> standings,
                            std::map<std::string, catalog::Given> given)
{
    m_lessonsPage->setLessons(std::move(entries), std::move(standings), std::move(given));
}

void MainWindow::setFeedback(const std::vector<database::Feedback>& feedback)
{
    m_lessonsPage->setFeedback(feedback);
}

void MainWindow::showSaved(const QString& path)
{
    m_savedWork = m_workBeingSaved;
    showMessage(tr("The recording was saved as %1.").arg(QDir::toNativeSeparators(path)));
    if (const auto what = std::exchange(m_afterSaving, {}))
        what();
}

void MainWindow::setReplaying(bool replaying, double lengthS, core::grading::IdealTop ideal,
                              std::optional<lessons::Lesson> lesson, const QString& whose)
{
    if (replaying && !m_replaying)
        m_workAtRest = ownWork();
    m_replaying = replaying;
    m_replayIdeal = std::move(ideal);
    m_replayLesson = std::move(lesson);
    m_replayWhose = whose;
    m_room->panel().setLesson(lessonShown());
    m_replayCourse = {};
    showRemarks();
    if (replaying)
        m_trialCard->hide();
    // What was asked of one hand is no word about the other's bur.
    m_drillWish = {};
    m_burWish = {};
    m_actions->along->setChecked(false);
    m_room->replay().begin(lengthS);
    showReplayPaused(false);
    m_room->setReplaying(replaying);
    showHistory();
    enableActions();
}

void MainWindow::setReplayCourse(const replay::AttemptTimeline& course)
{
    std::vector<replay::Remark> remarks = std::move(m_replayCourse.remarks);
    m_replayCourse = course;
    m_replayCourse.remarks = std::move(remarks);
    m_room->replay().setCourse(asMayBeTold(m_replayCourse));
    markExercise();
}

void MainWindow::setRemarks(std::vector<replay::Remark> remarks)
{
    if (!m_replaying)
        return;
    m_replayCourse.remarks = std::move(remarks);
    m_room->replay().setCourse(asMayBeTold(m_replayCourse));
    showRemarks();
}

/// Words and place of what is remarked about now.
void MainWindow::showRemarks()
{
    std::vector<replay::Remark> now = m_replayCourse.remarksAt(m_session.recordedS);
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
    m_room->showRemark(words.join(u'\n'));
    m_view->setPins(std::move(pins));
}

/// One's own attempt so far, saved and played, would tell what went wrong.
replay::AttemptTimeline MainWindow::asMayBeTold(replay::AttemptTimeline course) const
{
    if (isExamRunning())
        course.infractions.clear();
    return course;
}

bool MainWindow::isExam() const
{
    return m_assignment && m_assignment->lesson && m_assignment->lesson->exam;
}

bool MainWindow::isExamRunning() const
{
    return isExam() && !m_isGraded && !m_examIsRefused;
}

/// Its time is over, or its score has been seen: what was cut stays as it is, and another attempt begins with a
/// whole tooth.
void MainWindow::endExam()
{
    if (!isExam())
        return;
    m_examIsOver = true;
    m_clock.stop();
    m_room->lesson().conclude(m_examIsRefused ? practice::LessonStrip::Ending::Refused
                                              : practice::LessonStrip::Ending::WithScore);
    m_room->setHintVisible(false);
    m_drillWasOn = m_drillWasOn || m_burRests || m_actions->drill->isChecked();
    m_burRests = false;
    wishDrill(false);
    enableActions();
}

void MainWindow::refuseExam()
{
    m_examIsRefused = true;
    endExam();
    setUsedUp(true);
    showMessage(text::begunElsewhereWords());
}

void MainWindow::showReplayPaused(bool paused)
{
    m_replayPaused = paused;
    m_actions->showReplayPaused(paused);
}

void MainWindow::showReplayEnd()
{
    showReplayPaused(true);
    offerToStop(tr("The recording has ended."));
}

void MainWindow::offerToStop(const QString& sentence)
{
    m_messages->say({kit::MessageBar::Kind::News,
                     sentence,
                     {},
                     tr("Stop the replay"),
                     [this] { emit replayStopRequested(); },
                     kit::MessageBar::Topic::Tooth});
}

core::terrain::PerMaterial MainWindow::ownWork() const
{
    if (m_replaying)
        return m_workAtRest;
    // Until the session has taken a new tooth it speaks of the one before.
    return m_session.toothGeneration == m_ownGeneration ? m_session.removedMm3 : core::terrain::PerMaterial{};
}

bool MainWindow::wouldLoseWork() const
{
    // A block on which a preset is tried is nobody's work.
    if (!m_replaying && m_trialCard->isVisibleTo(m_room))
        return false;
    if (m_examIsRefused)
        return false;
    const core::terrain::PerMaterial work = ownWork();
    return work != core::terrain::PerMaterial{} && work != m_savedWork;
}

void MainWindow::leaveWork(const std::function<void()>& what)
{
    if (!wouldLoseWork()) {
        what();
        return;
    }
    if (isExamRunning() && !m_replaying) {
        ask("workQuestion",
            {tr("The exam would end without a score."),
             tr("It still counts as an attempt. Your work cannot be graded later."), tr("&Grade it now"),
             [this] {
                 goTo(m_room);
                 emit gradeRequested();
             },
             what});
        return;
    }
    const auto save = [this, what] {
        m_afterSaving = what;
        askToSave();
    };
    ask("workQuestion", {tr("Your work would be lost."), tr("Your latest cuts are not saved as a recording."),
                         tr("&Save the recording …"), save, what});
}

bool MainWindow::isAtLockedDoor() const
{
    return isAtDoor() && !m_mayLeaveDoor && !m_who.isGuest();
}

void MainWindow::leaveUnsaved(const std::function<void()>& what)
{
    const QString unsaved = m_unsaved.what();
    if (unsaved.isEmpty()) {
        what();
        return;
    }
    // Somebody else may be at the locked door: they do not learn what the changes are about.
    const bool isLocked = isAtLockedDoor();
    ask("unsavedQuestion", kit::UnsavedChanges::question(
                               isLocked ? QString() : unsaved,
                               isLocked ? QString::fromStdString(m_who.fullName()) : QString(), [this, what, isLocked] {
                                   if (isLocked)  // the drafts of lessons wait on the disk for their owner
                                       m_editor->closeDrafts();
                                   m_unsaved.discard();
                                   what();
                               }));
}

/// What the disk has refused so far, whoever made it: with the program goes who tries it again.
void MainWindow::leaveGrades(const std::function<void()>& what)
{
    if (m_unkeptGrades == 0) {
        what();
        return;
    }
    ask("gradeQuestion", {tr("%n grade(s) are not saved yet and would be lost.", nullptr, m_unkeptGrades),
                          tr("The disk cannot be written to. Cusp tries again every few seconds while it runs. Free "
                             "some disk space, or check the permissions of the folder."),
                          {},
                          {},
                          what});
}

void MainWindow::ask(const char* name, const kit::ConfirmOverlay::Question& question)
{
    delete m_question;
    m_question = new kit::ConfirmOverlay(question, this);
    m_question->setObjectName(QLatin1String(name));
}

void MainWindow::askToSave()
{
    m_files->save(m_actions->saveRecording->text(), FileDialogs::Kind::Recording,
                  newFileName(FileDialogs::Kind::Recording), [this](const QString& path) {
                      m_workBeingSaved = ownWork();
                      emit recordingSaveRequested(path);
                  });
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (m_mayClose || (m_unkeptGrades == 0 && !wouldLoseWork() && m_unsaved.what().isEmpty())) {
        kit::memory().setValue(kGeometry, saveGeometry());
        return;
    }
    event->ignore();
    const auto leave = [this] {
        m_mayClose = true;
        close();
        m_mayClose = false;  // it may not have been closed after all
    };
    leaveGrades([this, leave] { leaveWork([this, leave] { leaveUnsaved(leave); }); });
}

QString MainWindow::newFileName(FileDialogs::Kind kind) const
{
    return FileDialogs::newFileName(m_tooth->name, kind);
}

void MainWindow::openFile(const QString& path)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == FileDialogs::suffixOf(FileDialogs::Kind::Recording))
        emit recordingOpenRequested(path);
    else if (FileDialogs::scanSuffixes().contains(suffix))
        leaveWork([this, path] { emit scanChosen(path); });
    else
        m_messages->say({kit::MessageBar::Kind::Error,
                         tr("This is neither a scan (OBJ, STL, PLY) nor a recording. Drop one of those."),
                         QFileInfo(path).fileName(),
                         {},
                         {}});
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    placeOverlays();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!droppedFile(event->mimeData()).isEmpty() && !m_busy->isWorking() && !isAtDoor())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    openFile(droppedFile(event->mimeData()));
}

}  // namespace ui::window
