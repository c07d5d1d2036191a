// SPDX-License-Identifier: GPL-3.0-or-later
// Opens every page, card and dialog of one window while the language changes. All texts must change with it and have
// enough room.
//
// For a new page, add a line to pages_data() that opens it in English with some content. On an enlarged screen
// (QT_SCALE_FACTOR=1.5) the pages are opened in the other language, and only the room is checked.
#include <functional>

#include <QDir>
#include <QMenu>
#include <QPushButton>
#include <QScopeGuard>
#include <QSet>
#include <QStackedWidget>

#include "core/session/SessionChannels.h"
#include "lessons/PresetShelf.h"
#include "tests/support/OpenGlMain.h"
#include "tests/ui/Pictures.h"
#include "tests/ui/PseudoLanguage.h"
#include "tests/ui/WindowTest.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/AuditPart.h"
#include "ui/admin/BackupPart.h"
#include "ui/admin/PeoplePart.h"
#include "ui/admin/RosterPart.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/console/Console.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/HandList.h"
#include "ui/devices/HeadTrackingCard.h"
#include "ui/devices/PedalCard.h"
#include "ui/devices/SoundCard.h"
#include "ui/inside/XrayPage.h"
#include "ui/kit/BusyOverlay.h"
#include "ui/kit/LanguageMenu.h"
#include "ui/lessoneditor/LessonEditor.h"
#include "ui/people/AssignPage.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/people/LoginPage.h"
#include "ui/practice/HandControls.h"
#include "ui/practice/SidePanel.h"
#include "ui/scoring/CommentsPanel.h"
#include "ui/scoring/ScorePage.h"
#include "ui/text/Language.h"
#include "ui/toothchooser/Mouth.h"

using namespace core::session;
using namespace ui::kit;
using namespace ui::toothchooser;
using lessons::CatalogEntry;
using lessons::Task;

namespace {

constexpr const char* kThen = "2026-05-04T10:20:30Z";

QDateTime thenOnTheClock()
{
    return QDateTime::fromString(kThen, Qt::ISODate);
}

bool isEnlarged()
{
    return qApp->devicePixelRatio() > 1.0;
}

/// Returns the size of a window on a screen of 1280 x 800 pixels.
QSize roomInside()
{
    return isEnlarged() ? QSize(853, 493) : QSize(1280, 760);
}

std::vector<CatalogEntry> catalog()
{
    std::vector<CatalogEntry> entries = support::catalog();
    for (CatalogEntry& entry : entries)
        entry.read.lesson = pseudo::said(*entry.read.lesson);
    return entries;
}

lessons::Assignment assigned(Task task)
{
    lessons::Assignment assignment = support::assigned(task);
    assignment.lesson = pseudo::said(*assignment.lesson);
    assignment.rubric = assignment.lesson->rubric;
    return assignment;
}

lessons::ScoreSheet sheet()
{
    lessons::ScoreSheet marked = support::sheet(3.2, 40.0, 0.5);
    marked.rubricTitle = {{"en", "[·]"}};
    for (lessons::Criterion& criterion : marked.criteria)
        criterion.title = {{"en", "[·· ·]"}};
    return marked;
}

const lessons::ReadLesson& cutIdeal()
{
    return support::shippedWhere(
        [](const lessons::Lesson& lesson) { return lesson.task == Task::CutIdeal && !lesson.exam; });
}

core::grading::Infraction breach()
{
    core::grading::Infraction infraction;
    infraction.breach = core::grading::RuleViolation::TooDeep;
    infraction.limit = 2.5;
    infraction.seconds = 20.5;
    return infraction;
}

database::AttemptRecord attempt(int tenths, const std::string& hash)
{
    database::AttemptRecord record;
    record.scoreTenths = tenths;
    record.rubricHash = hash;
    record.finishedUtc = kThen;
    return record;
}

database::AttemptRecord charted(int number)
{
    database::AttemptRecord record = attempt(500 + 10 * number, "");
    record.id = number;
    record.lessonId = "0";
    record.durationMs = 60'000 * number;
    record.meanForceMn = 800;
    record.peakForceMn = 1200;
    return record;
}

/// Returns a class of three: one needs help, one has never logged in, one has not begun.
database::ClassOverview classOfThree()
{
    database::ClassOverview shown;
    shown.id = {7};
    shown.name = "[···]";
    shown.lessons = {"0"};
    shown.students = {{{1}, "", "[···]", kThen, kThen, {5, 5, 5}, {false, false, false}, "0"},
                      {{2}, "", "[···]", "", "", {}, {}, ""},
                      {{3}, "", "[···]", kThen, "", {}, {}, ""}};
    shown.cells = {{{3, 5, false, kThen}}, {{}}, {{}}};
    return shown;
}

database::LessonResults resultsOfSix()
{
    database::LessonResults results;
    results.lessonId = "0";
    results.bestTenths = {100, 300, 500, 600, 800, 900};
    results.curve = {{1, 6, 200, 400, 600}, {2, 6, 300, 500, 700}};
    results.difficulty = {"0", 6, 2, 400.0, 1.5, {{"a", 0.4}, {"b", 0.2}}};
    return results;
}

}  // namespace

using BringUp = std::function<void()>;
Q_DECLARE_METATYPE(BringUp)

class TestLanguages : public support::WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        prepare();
        ui::text::Language::choose("en_GB");
        if (isEnlarged())
            QCoreApplication::installTranslator(&m_strange);
        openWindow();
        m_window->resize(roomInside());
    }
    /// Resets the window as a logout does, which is faster than making a new one.
    void init()
    {
        ui::text::Language::choose("en_GB");
        m_window->account().ask(ui::people::LoginMode::Login);
        m_window->leaveAll();
        m_window->setWho({});
        m_window->setReplaying(false);
        m_window->replayView().hideBeside();
        m_beside.reset();
        m_window->setAssignment({});
        m_links->session.publish({});
        static_cast<void>(allSent());
        show();
        for (QAction* panel : {actions().section, actions().history})
            if (panel->isChecked())
                panel->trigger();
        // Closes the overlays of the practice room one by one.
        for (int closed = 0; closed < 6; ++closed)
            actions().back->trigger();
    }
    void cleanupTestCase() { m_window.reset(); }

    void pages_data()
    {
        QTest::addColumn<BringUp>("bringUp");
        m_pages = 0;
        const auto page = [this](const char* name, const BringUp& bringUp) {
            ++m_pages;
            QTest::newRow(name) << bringUp;
        };
        page("practice", [this] {
            SessionState session;
            session.toothGeneration = m_generation;
            session.removedMm3 = {0.0, 188.88, 188.88, 0.0};
            m_links->session.publish(session);
        });
        page("burs", [this] { actions().allBurs->trigger(); });
        for (const auto& [name, action] : {std::pair("section", &Actions::section),
                                           {"stereo", &Actions::stereoPage},
                                           {"history", &Actions::history},
                                           {"help", &Actions::help},
                                           {"teeth", &Actions::chooseTooth},
                                           {"settings", &Actions::settings},
                                           {"console", &Actions::console}})
            page(name, [this, action = action] { (actions().*action)->trigger(); });
        for (const auto& [name, stage] : {std::pair("device denied", DeviceStage::Unavailable),
                                          {"device without firmware", DeviceStage::NeedsFirmware},
                                          {"device homing", DeviceStage::Homing},
                                          {"device ready", DeviceStage::Ready}})
            page(name, [this, stage = stage] {
                ui::devices::DeviceKind kind;
                kind.id = kind.name = kind.rule = kind.ruleFile = kind.ruleCommand = "[···]";
                DeviceReport report;
                report.stage = stage;
                report.error.code = core::ErrorCode::NotAllowed;
                report.buttons = 1;
                m_window->devicesPage().setKinds({kind});
                m_window->devicesPage().setReport(kind.id, report);
                m_window->devicesPage().setChosen(kind.id);
                actions().devices->trigger();
            });
        for (const auto& [name, stage] : {std::pair("head tracking", core::tracking::TrackerStage::Tracking),
                                          {"head tracking without a camera", core::tracking::TrackerStage::NoCamera},
                                          {"head tracking, off", core::tracking::TrackerStage::Opening}})
            page(name, [this, stage = stage] {
                ui::devices::HeadTrackingCard& card = m_window->devicesPage().headTracking();
                ui::devices::HeadTrackingSettings settings;
                settings.isOn = stage != core::tracking::TrackerStage::Opening;
                card.setCameras({});
                card.setSettings(settings);
                core::tracking::TrackerReport report;
                report.stage = stage;
                report.error = {core::ErrorCode::Busy, {}, {"There is no file %1.", {core::noted("[···]")}}};
                report.hz = 30.0;
                report.latencyMs = report.seenShare = 1.0;
                card.setTracking(report);
                m_window->devicesPage().setKinds({});
                m_window->devicesPage().setChosen(ui::devices::kPointer);
                actions().devices->trigger();
                child<ui::devices::HandList>()->selectHand(ui::devices::kHeadTracking);
            });
        for (const bool isPluggedIn : {true, false})
            page(isPluggedIn ? "pedal and gamepad" : "pedal that is missing", [this, isPluggedIn] {
                core::session::ControllerReport report;
                report.pedal =
                    isPluggedIn ? core::session::PedalStage::WaitsForRest : core::session::PedalStage::Missing;
                if (isPluggedIn) {
                    core::session::Controller pad;
                    pad.name = "[···]";
                    pad.isGamepad = true;
                    pad.instance = 1;
                    pad.axes.resize(core::session::kGamepadAxes);
                    pad.presses.resize(core::session::kGamepadButtons);
                    report.controllers = {pad, pad};
                }
                m_window->devicesPage().pedals().setPedal("[···]", "[···]");
                m_window->devicesPage().pedals().setReport(report);
                m_window->devicesPage().setKinds({});
                m_window->devicesPage().setChosen(ui::devices::kPointer);
                actions().devices->trigger();
                child<ui::devices::HandList>()->selectHand(ui::devices::kPedals);
            });
        for (const auto stage : {ui::sound::SoundStage::Off, ui::sound::SoundStage::NoOutput,
                                 ui::sound::SoundStage::Refused, ui::sound::SoundStage::Playing})
            page("sound", [this, stage] {
                ui::devices::SoundCard& card = m_window->devicesPage().sound();
                card.setOutputs({});
                ui::sound::SoundSettings settings;
                settings.output = "[···]";
                card.setSettings(settings);
                ui::sound::SoundReport report;
                report.stage = stage;
                report.output = QStringLiteral("[···]");
                card.setReport(report);
                m_window->devicesPage().setKinds({});
                m_window->devicesPage().setChosen(ui::devices::kPointer);
                actions().devices->trigger();
                child<ui::devices::HandList>()->selectHand(ui::devices::kSound);
            });
        page("pen", [this] {
            m_window->devicesPage().setKinds({});
            m_window->devicesPage().setChosen(ui::devices::kPointer);
            actions().devices->trigger();
        });
        for (const bool isForceDevice : {true, false})
            for (const int step : {0, 1, 2, 3, 4})
                page(isForceDevice ? "guide of a device" : "guide of a mouse", [this, isForceDevice, step] {
                    ui::devices::DeviceKind kind;
                    kind.id = kind.name = "[···]";
                    DeviceReport report;
                    report.stage = DeviceStage::Ready;
                    report.tipMm = {0.0F, 0.0F, 44.0F};
                    m_window->devicesPage().setKinds({kind});
                    m_window->devicesPage().setReport(kind.id, report);
                    m_window->devicesPage().setChosen(isForceDevice ? kind.id : ui::devices::kPointer);
                    actions().devices->trigger();
                    child<QPushButton>("openHandGuide")->click();
                    for (int k = 0; k < step; ++k)
                        child<QPushButton>("guideNext")->click();
                    if (step == 2 && isForceDevice)
                        child<QPushButton>("storeHeight")->click();
                });
        page("hand", [this] {
            m_window->devicesPage().setKinds({});
            m_window->devicesPage().setChosen(ui::devices::kSimulated);
            actions().devices->trigger();
            m_window->room().panel().hand().setForceDevice("[···]");
        });
        page("busy", [this] {
            m_window->showBusy("[···]");
            QTRY_VERIFY(child<BusyOverlay>()->isVisible());
        });
        page("message", [this] { m_window->showMessage("[···]"); });
        page("error", [this] {
            m_window->showError({core::ErrorCode::WrongKind, {}}, ui::text::FailedOperation::KeepingGrades,
                                QString(80, u'·'));
        });
        page("replay", [this] {
            m_window->setReplaying(true, 60.0);
            m_window->replayView().setCourse(support::course());
            m_beside = std::make_unique<UiChannels>();
            m_window->showBeside(*m_beside, support::syntheticMolar(), 1, {}, "[···]");
        });
        page("tour", [this] { m_window->beginTour(); });
        page("mouth", [this] {
            if (Mouth::isPossible())
                actions().mouth->trigger();
        });
        page("xray", [this] {
            actions().radiograph->trigger();
            QTRY_VERIFY(child<ui::inside::XrayPage>()->isReady());
        });
        page("lessons", [this] {
            const QDateTime now = QDateTime::currentDateTime();
            m_window->lessonsPage().setLessons(
                catalog(), {{"decay-21-small", {3, 872, true, kThen}}, {"class1-36", {3, 572, false, kThen}}},
                {{"class1-36", {"[···]", now.addDays(-2), 2}}, {"decay-36-small", {"[···]", now.addDays(1), {}}}});
            actions().lessons->trigger();
        });
        page("feedback", [this] {
            m_window->lessonsPage().setFeedback({{{1}, "class1-36", "[···]", kThen, true}});
            openLessons();
        });
        page("unfinished", [this] {
            openLessons();
            m_window->resumeOffer().offer([] { return QString("[···]"); }, thenOnTheClock(), false);
        });
        page("no lesson", [this] {
            openLessons();
            child<ui::catalog::LessonsPage>()->findChild<QLineEdit*>()->setText("0x0x0");
        });
        for (const int part : {0, 1})
            page(part == 0 ? "editor" : "editor, past attempts", [this, part] {
                auto* editor = child<ui::lessoneditor::LessonEditor>();
                editor->edit(cutIdeal(), QDir::temp().filePath(QStringLiteral("no such folder")));
                qobject_cast<QStackedWidget*>(editor->parentWidget())->setCurrentWidget(editor);
                QTRY_VERIFY_WITH_TIMEOUT(!editor->findChild<QLabel*>("selfCheck")->text().isEmpty(), 60000);
                QList<QAbstractButton*> parts;
                for (auto* choice : editor->findChildren<QAbstractButton*>())
                    if (choice->property("kind") == "segment")
                        parts << choice;
                parts.at(part)->click();
            });
        for (const bool mayKeep : {true, false})
            page(mayKeep ? "presets" : "presets, a student's", [this, mayKeep] {
                m_window->hardness().setMayKeep({}, mayKeep);
                openPresets();
            });
        page("presets, all numbers", [this] {
            openPresets();
            child<QPushButton>("presetExpert")->click();
        });
        page("trial", [this] {
            openPresets();
            child<QPushButton>("presetTry")->click();
            m_window->beginTrial();
            actions().back->trigger();
        });
        page("attempts", [this] {
            m_window->historyPage().setLessonTitles({{"0", "[···]"}});
            m_window->historyPage().setHistory({charted(3), charted(2), charted(1)});
            m_window->navigation().openHistory();
        });
        page("no attempts", [this] { m_window->navigation().openHistory(); });
        page("classes", [this] {
            m_window->classPage().setClasses({{{7}, "[···]", 3, 1}});
            m_window->classPage().setLessonTitles({{"0", "[···]"}});
            m_window->classPage().setOverview(classOfThree());
            m_window->classPage().setResults(resultsOfSix(), 700, {{"a", "[···]"}, {"b", "[····]"}});
            m_window->navigation().openClasses();
        });
        page("no classes", [this] { m_window->navigation().openClasses(); });
        page("assign", [this] {
            m_window->assignPage().setLessons(
                {{"0", "[···]", "[··]", "[·]", {}, 0}, {"1", "[····]", "[··]", "[·]", {}, 0}});
            // Uses today's date, because the names of months come from Qt.
            const std::string now = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
            m_window->assignPage().setAssignments({{7}, "[·]", {}, {}, {}}, {{1, {7}, "1", now, 3}});
            m_window->assignPage().confirm({{{}, database::ClassAssignment{1, {7}, "1", "", 0}}});
            m_window->navigation().openAssign();
        });
        for (const auto& [name, part] : {std::pair("school, people", ui::admin::AdminPage::People),
                                         {"school, class list", ui::admin::AdminPage::Roster},
                                         {"school, backups", ui::admin::AdminPage::Backups},
                                         {"school, audit", ui::admin::AdminPage::Audit},
                                         {"school, computer", ui::admin::AdminPage::Station}})
            page(name, [this, part = part] { openSchool(part); });
        page("watch", [this] {
            actions().console->trigger();
            auto* console = child<ui::console::Console>();
            console->execute(QStringLiteral("watch force.stiffness"));
            console->close();
        });
        for (const auto& [name, task] : {std::pair("lesson", Task::RemoveDecay),
                                         {"lesson of an ideal", Task::CutIdeal},
                                         {"touch", Task::TouchPoints},
                                         {"hold", Task::HoldForce},
                                         {"layers", Task::TellLayers}})
            page(name, [this, task = task] { beginLesson(assigned(task)); });
        page("breach", [this] {
            beginLesson(assigned(Task::RemoveDecay));
            m_window->infractionView().show(breach(), true);
        });
        page("layers, graded", [this] {
            beginLesson(assigned(Task::TellLayers));
            m_window->showScore(sheet(), {});
            actions().back->trigger();
        });
        page("forecast", [this] {
            beginLesson(assigned(Task::RemoveDecay));
            m_window->askPrediction();
        });
        page("score", [this] { showScore(); });
        page("talk", [this] {
            showScore();
            m_window->scorePage().setTalkVisible(true);
            ui::scoring::CommentsPanel& talk = m_window->scorePage().talk();
            talk.setScore(512, 600, false);
            talk.setMay(true, true);
            database::AttemptTalk said;
            said.comments.push_back({1, "[···]", kThen, "[···]", std::array{1.0, 2.0, 3.0}, 4000, true});
            said.overrides.push_back({"[···]", kThen, 700, "[···]"});
            talk.setTalk(said);
            talk.setMoment(4000);
            talk.setPlace(std::array{1.0, 2.0, 3.0});
        });
        for (const auto& [name, door] : {std::pair("login", ui::people::LoginMode::Login),
                                         {"new password", ui::people::LoginMode::NewPassword},
                                         {"welcome", ui::people::LoginMode::Welcome},
                                         {"new school", ui::people::LoginMode::NewSchool},
                                         {"own password", ui::people::LoginMode::OwnPassword},
                                         {"locked", ui::people::LoginMode::Locked}})
            page(name, [this, door = door] { m_window->account().ask(door); });
        page("login, damaged", [this] {
            m_window->account().ask(ui::people::LoginMode::Login);
            m_window->account().setUnreachable(core::Error{core::ErrorCode::BadStructure, {}}, "[···]",
                                               thenOnTheClock());
        });
    }

    void pages()
    {
        QFETCH(BringUp, bringUp);
        bringUp();
        // Texts that are the same in every language: the title of the edited lesson, the file of the tooth, commands,
        // and the names of presets.
        QStringList fromOutside{"KiB",
                                "Qt",
                                "natural",
                                "synthetic",
                                child<QLineEdit>("draftTitle")->text(),
                                "export   get   help   list   load   plot   reset   save   set   unwatch   watch"};
        for (const core::settings::FeelPreset& shipped : lessons::shippedPresets())
            fromOutside << QString::fromStdString(shipped.hash).left(8);
        for (const QInputDevice* device : QInputDevice::devices())
            for (const QString& word : device->name().split(u' '))
                fromOutside << word;
        for (const lessons::CriterionRule& rule : cutIdeal().lesson->rubric.criteria)
            fromOutside << QString::fromStdString(lessons::inLanguage(rule.title, "en"));
        // Texts that are computed in another thread appear slightly later, and a layout takes several passes.
        QStringList found;
        const auto isSound = [&] {
            found = pseudo::clipped(*m_window);
            if (!isEnlarged())
                found << pseudo::notTranslated(*m_window, fromOutside);
            return found.isEmpty();
        };
        if (!isEnlarged())
            QCoreApplication::installTranslator(&m_strange);
        const auto back = qScopeGuard([this] {
            if (!isEnlarged())
                QCoreApplication::removeTranslator(&m_strange);
        });
        QCoreApplication::processEvents();
        QVERIFY2(QTest::qWaitFor(isSound, 20000), qPrintable(found.join('\n')));
        look();
        pictures::keep(m_window->grab().toImage(),
                       QString("strange-%1-%2").arg(QTest::currentDataTag()).arg(roomInside().width()));
    }

    /// If you add a page, a card or a panel, add it to pages_data().
    void everyPartWasBroughtUp()
    {
        if (m_looks < m_pages)
            QSKIP("only some pages were opened");
        const QStringList missing = (m_parts - m_seen).values();
        QVERIFY2(missing.isEmpty(), qPrintable("never on the screen: " + missing.join(", ")));
    }

    void questionsAreAskedInTheLanguageOfToday()
    {
        QCoreApplication::installTranslator(&m_strange);
        const auto back = qScopeGuard([this] { QCoreApplication::removeTranslator(&m_strange); });
        SessionState session;
        session.toothGeneration = m_generation;
        session.undoSteps = 1;
        session.removedMm3 = {0.0, 5.0, 0.0, 0.0};
        m_links->session.publish(session);
        QTRY_VERIFY(actions().undo->isEnabled());
        m_window->close();
        auto* question = child<ConfirmOverlay>();
        QVERIFY(question != nullptr && question->isVisible());
        QCOMPARE(pseudo::notTranslated(*question), QStringList());
        QTRY_COMPARE(pseudo::clipped(*question), QStringList());
        QTest::keyClick(question, Qt::Key_Escape);
    }

    void messagesThatStayFollowTheLanguage()
    {
        m_window->showTooth(support::syntheticMolar(), ++m_generation, [] {
            return QStringList{QCoreApplication::translate("Tooth", "enamel"), "two"};
        });
        m_window->showError(core::Error{core::ErrorCode::FileUnreadable, "exact"},
                            ui::text::FailedOperation::OpeningScan, "a.stl");
        m_window->resumeOffer().offer([] { return QCoreApplication::translate("Tooth", "enamel"); }, thenOnTheClock(),
                                      false);
        auto* bar = child<ui::kit::MessageBar>();
        const QString english = bar->sentence();
        QVERIFY2(english.contains("was not finished"), qPrintable(english));
        ui::text::Language::choose("de");
        const auto back = qScopeGuard([] { ui::text::Language::choose("en_GB"); });
        QTRY_VERIFY2(bar->sentence().contains("nicht beendet"), qPrintable(bar->sentence()));
        // The message that waits behind it is in the current language as well.
        bar->dismiss();
        QVERIFY2(bar->sentence().contains("Scan") && !bar->sentence().contains("cannot be opened"),
                 qPrintable(bar->sentence()));
        ui::text::Language::choose("en_GB");
        QTRY_VERIFY2(bar->sentence().contains("cannot be opened"), qPrintable(bar->sentence()));
        bar->dismiss();
        QCOMPARE(bar->sentence(), "2 notes about this scan");
    }

    void whatIsSaidAtTheDoorFollowsTheLanguage()
    {
        m_window->account().ask(ui::people::LoginMode::Login);
        const auto back = qScopeGuard([this] {
            ui::text::Language::choose("en_GB");
            m_window->setWho({});
        });
        m_window->account().say([] { return QCoreApplication::translate("Material", "enamel"); });
        m_window->account().refuse({core::ErrorCode::WrongLogin, "no"});
        const auto says = [this](const QString& words) {
            const auto labels = m_window->findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(), [&](const QLabel* one) {
                return one->isVisibleTo(m_window.get()) && one->text().contains(words);
            });
        };
        QVERIFY(says("enamel") && says("Wrong username or password"));
        ui::text::Language::choose("de");
        QTRY_VERIFY(says("Schmelz") && says("Passwort ist falsch"));
    }

    void theMenuChoosesAndRemembers()
    {
        using ui::text::Language;
        auto* menu = child<LanguageMenu>();
        QStringList names;
        for (const QAction* action : menu->actions())
            names << action->text();
        QVERIFY(names.contains("English") && names.contains("Deutsch"));
        QCOMPARE(names.size(), Language::available().size());
        QVERIFY(LanguageMenu::remembered().isEmpty());
        menu->actions().at(names.indexOf("Deutsch"))->trigger();
        QTRY_COMPARE(Language::current(), "de");
        QCOMPARE(LanguageMenu::remembered(), "de");
        QTRY_COMPARE(actions().undo->text(), "Rückgängig");
        // A language selected in one menu is selected in all of them.
        for (const auto* each : m_window->findChildren<LanguageMenu*>())
            QTRY_VERIFY(each->actions().at(names.indexOf("Deutsch"))->isChecked());
        menu->actions().at(names.indexOf("English"))->trigger();
        QTRY_COMPARE(actions().undo->text(), "Undo");
    }

    void numbersFollowAndWhatIsNotSpokenIsEnglish()
    {
        using ui::text::Language;
        for (const auto& [locale, language, number] :
             {std::tuple("de_AT", "de", "1,5"), {"en_GB", "en", "1.5"}, {"fi_FI", "en", "1,5"}}) {
            Language::choose(locale);
            QCOMPARE(Language::current(), language);
            QCOMPARE(ui::text::number(1.5, 1), number);
        }
        QTRY_COMPARE(actions().undo->text(), "Undo");
        QVERIFY(!Language::isAvailable("xx") && Language::isAvailable("de_CH"));
    }

private:
    void showScore()
    {
        const lessons::Assignment assignment = assigned(Task::RemoveDecay);
        beginLesson(assignment);
        ui::scoring::ScoredWork scored;
        scored.tooth = std::make_shared<const core::terrain::Tooth>(assignment.anatomy);
        scored.ideal = assignment.shownIdeal();
        scored.measured.measures = core::grading::measure(*scored.tooth);
        scored.measured.process.emplace();
        scored.infractions = {breach(), breach(), breach()};
        const lessons::ScoreSheet marked = sheet();
        m_window->showScore(marked, {attempt(512, marked.rubricHash), attempt(700, "another")},
                            ui::scoring::ScorePrediction{900, "caries_left"}, scored);
        const lessons::Moment moment{lessons::Moment::Kind::Stroke, 100, 754000, 754.0, 128};
        const lessons::Moment never{lessons::Moment::Kind::Never, 340, 754000, 754.0, 0};
        m_window->scorePage().setMoments({{never, moment}, {moment}, {moment}});
        lessons::GridSensitivity noise;
        noise.half.totalTenths = 500;
        m_window->scorePage().setNoise(noise);
        m_window->scorePage().setClass({7, 40.0});
    }

    void look()
    {
        ++m_looks;
        for (const QWidget* part : m_window->findChildren<QWidget*>()) {
            const QString kind = QString::fromLatin1(part->metaObject()->className());
            // The texts of a menu are checked without opening it.
            if (!kind.startsWith(u"ui::") || qobject_cast<const QMenu*>(part) != nullptr)
                continue;
            m_parts << kind;
            if (part->isVisible())
                m_seen << kind;
        }
    }

    void openLessons()
    {
        m_window->lessonsPage().setLessons(catalog(), {});
        actions().lessons->trigger();
    }

    void openPresets()
    {
        m_window->hardness().setPresets(lessons::shelved({}), lessons::shippedPresets().front());
        actions().presets->trigger();
    }

    void openSchool(ui::admin::AdminPage::Part part)
    {
        ui::admin::AdminPage& school = m_window->adminPage();
        qobject_cast<QStackedWidget*>(school.parentWidget())->setCurrentWidget(&school);
        school.show(part);
        const database::Person person{{1},   "a",  "[···]", "[··]", "[···]", database::Role::Admin,
                                      false, true, "",      kThen,  {{1}}};
        school.people().setPeople({person}, {{{1}, "[···]", 1, 1}});
        school.people().confirm({1}, [] { return QString("[···]"); });
        school.people().showCode(person, "[···]");
        school.roster().showOutcome({{},
                                     {{"[···]", "[···]", database::Role::Student, {"[···]"}, true, "[···]", {}},
                                      {"[···]", "[···]", database::Role::Student, {"[···]"}, false, {}, "[···]"}},
                                     {}},
                                    "[···]", true);
        school.backups().setDatabase("[···]", false);
        school.backups().setBackups({{"[···]", thenOnTheClock(), 1024}});
        school.backups().finish([] { return QStringLiteral("[···]"); }, {{"%1 was removed", {"attempt:[···]"}}});
        school.audit().setRows({{1, kThen, "", "login", "[···]", "{}", ""}}, "[···]", true);
    }

    std::unique_ptr<UiChannels> m_beside;
    QSet<QString> m_parts;  ///< classes of ui of which the window has a widget
    QSet<QString> m_seen;   ///< classes that were visible
    int m_pages = 0;
    int m_looks = 0;
    pseudo::Translator m_strange;
};

int main(int argc, char* argv[])
{
    return support::openGlMain<TestLanguages>(argc, argv);
}

#include "tst_languages.moc"
