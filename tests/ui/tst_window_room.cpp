// SPDX-License-Identifier: GPL-3.0-or-later
// The main window in the practice room: its keys, its figures, and its messages.
#include <utility>

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>
#include <QSlider>
#include <QStringList>
#include <QToolButton>

#include "core/bur/Bur.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "tests/support/Suite.h"
#include "tests/ui/WindowTest.h"
#include "ui/console/Console.h"
#include "ui/inside/SectionView.h"
#include "ui/inside/XrayPage.h"
#include "ui/kit/BusyOverlay.h"
#include "ui/practice/BurChooser.h"
#include "ui/practice/BurPicker.h"
#include "ui/practice/SidePanel.h"
#include "ui/toothchooser/ToothChooser.h"
#include "ui/window/HelpOverlay.h"

using namespace core::session;
using namespace core::servo;
using namespace ui::kit;
using namespace ui::practice;
using namespace ui::toothchooser;
using namespace ui::window;
using core::terrain::Material;
using ui::inside::SectionView;
using ui::text::FailedOperation;

namespace {

/// Returns the texts of the labels that are direct children of `widget`, in their order.
QStringList labelTexts(const QWidget& widget)
{
    QStringList texts;
    for (const QLabel* label : widget.findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
        texts << label->text();
    return texts;
}

}  // namespace

class TestWindowRoom : public support::WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void keysSendCommands()
    {
        for (const auto& [keys, command] : {std::pair("Ctrl+Z", SessionCommand(Undo{})),
                                            {"Ctrl+Shift+Z", Redo{}},
                                            {"D", SetDrill{true}},
                                            {"Space", SetDrill{false}},
                                            {"2", SetBur{1}},
                                            {"4", SetBur{3}},
                                            {"R", Reload{}}}) {
            press(QKeySequence(keys));
            const auto got = sent();
            QCOMPARE(got.size(), std::size_t{1});
            QVERIFY2(got[0].index() == command.index(), keys);
            if (const auto* drill = std::get_if<SetDrill>(&command))
                QCOMPARE(std::get<SetDrill>(got[0]).on, drill->on);
            if (const auto* bur = std::get_if<SetBur>(&command))
                QCOMPARE(std::get<SetBur>(got[0]).index, bur->index);
        }
        QCOMPARE(actions().burs.size(), static_cast<qsizetype>(core::bur::burs().size()));
    }

    void onlyHandpiecesAtHandCanBeTaken()
    {
        using core::settings::findHandpiece;
        press(Qt::Key_9);
        // The lesson sets the order: the low-speed handpiece is the first, and the electric one is not available.
        m_window->setHandpieces({findHandpiece("low-speed").value(), findHandpiece("turbine").value()});
        for (const Qt::Key key : {Qt::Key_9, Qt::Key_8, Qt::Key_7})
            press(key);
        QList<int> taken;
        for (const SessionCommand& command : sent())
            taken << std::get<SetHandpiece>(command).index;
        QCOMPARE(taken, (QList<int>{2, 0, 1}));
    }

    void theServoHasTheLastWordOnDrillAndBur()
    {
        spoil();
        ServoState servo;
        servo.tick = 1;
        servo.drillOn = true;
        servo.burIndex = 2;
        take(servo, {});
        QTRY_VERIFY(actions().drill->isChecked());
        QTRY_VERIFY(actions().burs[2]->isChecked());
        QVERIFY2(sent().empty(), "what the servo says is shown, not sent back");
        // A wish that the servo does not follow is given up.
        press(Qt::Key_D);
        QVERIFY(!actions().drill->isChecked());
        QTRY_VERIFY(actions().drill->isChecked());
    }

    void undoRestsWhileThereIsNothingToUndo()
    {
        take({}, {});
        QVERIFY(!actions().undo->isEnabled() && !actions().redo->isEnabled());
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(sent().empty());
    }

    void gradeIsAskedFor()
    {
        QSignalSpy asked(m_window.get(), &MainWindow::gradeRequested);
        press(Qt::Key_G);
        QCOMPARE(asked.size(), 1);
        // The space bar presses a button that has the focus, and the drill does not start.
        QPushButton* grade = nullptr;
        for (QPushButton* button : child<PracticeRoom>()->findChildren<QPushButton*>())
            if (button->text() == actions().grade->text())
                grade = button;
        QVERIFY(grade != nullptr);
        grade->setFocus(Qt::TabFocusReason);
        press(Qt::Key_Space);
        QCOMPARE(asked.size(), 2);
        QVERIFY(sent().empty());
        // Not once more: the grade is already there.
        m_window->showScore(support::sheet(0, 0, 0), {});
        press(Qt::Key_G);
        QCOMPARE(asked.size(), 2);
    }

    void homeIsOfferedWhereAHandCanBeLed()
    {
        spoil();
        press(Qt::Key_C);
        QVERIFY(sent().empty());
        m_window->offerHome(true);
        press(Qt::Key_C);
        const auto commands = sent();
        QCOMPARE(commands.size(), std::size_t{1});
        QVERIFY(std::holds_alternative<BringHome>(commands.front()));
        m_window->setReplaying(true);
        press(Qt::Key_C);
        QVERIFY(sent().empty());
    }

    void filesAreAskedFor()
    {
        const QTemporaryDir folder;
        QSignalSpy scan(m_window.get(), &MainWindow::scanChosen);
        QSignalSpy open(m_window.get(), &MainWindow::recordingOpenRequested);
        QSignalSpy save(&m_window->unsavedWork(), &ui::window::UnsavedWork::recordingSaveRequested);
        for (const auto& [keys, file, spy] : {std::tuple("Ctrl+O", "scan.stl", &scan),
                                              {"Ctrl+Shift+O", "attempt.cusprec", &open},
                                              {"Ctrl+S", "new.cusprec", &save}}) {
            const QString path = folder.filePath(file);
            const bool isSaved = spy == &save;
            QFile made(path);
            QVERIFY(isSaved || made.open(QIODevice::WriteOnly));
            press(QKeySequence(keys));
            QVERIFY(!isSaved || child<QFileDialog>()->selectedFiles().value(0).endsWith(".cusprec"));
            accept(path);
            QCOMPARE(spy->size(), 1);
            QCOMPARE(spy->front().front().toString(), path);
            QTRY_VERIFY(child<QFileDialog>() == nullptr);
        }
    }

    void droppedFilesAreToldApart()
    {
        QSignalSpy scan(m_window.get(), &MainWindow::scanChosen);
        QSignalSpy open(m_window.get(), &MainWindow::recordingOpenRequested);
        QVERIFY(dropFile("/tmp/Molar.STL"));
        QCOMPARE(scan.size(), 1);
        QVERIFY(dropFile("/tmp/attempt.cusprec"));
        QCOMPARE(open.size(), 1);
        QMimeData words;
        words.setText("not a file");
        QVERIFY(!drop(words));
        QVERIFY(dropFile("/tmp/letter.docx"));
        QCOMPARE(scan.size() + open.size(), 2);
        QVERIFY(message().contains("neither a scan"));
    }

    void theNextWindowIsLaidOutAsThisOne()
    {
        spoil();
        press(Qt::Key_F11);
        QVERIFY(m_window->isFullScreen());
        press(Qt::Key_Escape);
        QVERIFY(!m_window->isFullScreen() && !actions().fullScreen->isChecked());
        m_window->resize(1011, 707);
        QVERIFY(child<SidePanel>()->isVisible() && !actions().otherHand->isChecked());
        press(Qt::Key_F9);
        press(Qt::Key_X);
        press(Qt::Key_H);
        m_window->close();
        openWindow();
        QCOMPARE(m_window->size(), QSize(1011, 707));
        QVERIFY(!child<SidePanel>()->isVisible() && !actions().panel->isChecked());
        QVERIFY(child<SectionView>()->isVisible() && actions().section->isChecked());
        QVERIFY(actions().turnSection->isEnabled() && actions().otherHand->isChecked());
        // A lesson's lock is not what the student wanted.
        forbid(&lessons::Aids::section);
        QVERIFY(!child<SectionView>()->isVisible());
        openWindow();
        QVERIFY(child<SectionView>()->isVisible());
        press(Qt::Key_F9);
        QVERIFY(child<SidePanel>()->isVisible());
        spoil();
    }

    void theAidsInUseAreNoted()
    {
        spoil();
        m_window->lessonController().setAids({});
        show();
        const auto first = aidsNoted();
        QVERIFY(first.has_value());
        QVERIFY((*first & kDepthGaugeAid) != 0 && (*first & kSectionAid) == 0);
        press(Qt::Key_X);
        QVERIFY(isNoted(kSectionAid) == true);
        press(Qt::Key_F);
        QVERIFY(isNoted(kRadiographAid) == true);
        press(Qt::Key_Escape);
        QVERIFY(isNoted(kRadiographAid) == false);
        QVERIFY2(!aidsNoted().has_value(), "said once");
        // What was out before, and is not seen where the lesson does not allow it, is not in use there.
        actions().mirror->setChecked(true);
        QVERIFY(isNoted(kMirrorAid) == true);
        forbid(&lessons::Aids::mirror);
        QVERIFY(isNoted(kMirrorAid) == false);
        m_window->lessonController().setAids({});
        actions().mirror->setChecked(false);
        static_cast<void>(aidsNoted());
        // The console tells no more than the lesson allows, and of what it tells that is noted, too.
        auto* console = child<ui::console::Console>();
        press(Qt::Key_F9);
        QVERIFY(isNoted(kDepthGaugeAid) == false);
        console->execute(QStringLiteral("watch live.depth"));
        QVERIFY(isNoted(kDepthGaugeAid) == true);
        m_window->lessonController().setAids(lessons::Aids::none());
        QVERIFY(isNoted(kDepthGaugeAid) == false);
        console->execute(QStringLiteral("get live.depth"));
        QVERIFY(child<QPlainTextEdit>("consoleOutput")->toPlainText().endsWith("This lesson does not allow it."));
    }

    void whatALessonLocksRests()
    {
        const auto* section = child<SectionView>();
        const auto* films = child<ui::inside::XrayPage>();
        press(Qt::Key_X);
        QVERIFY(section->isVisible());
        const QString tip = actions().section->toolTip();
        m_window->lessonController().setAids(lessons::Aids::none());
        QVERIFY(!section->isVisible());
        for (const QAction* aid : {actions().section, actions().turnSection, actions().radiograph}) {
            QVERIFY(!aid->isEnabled());
            QVERIFY(aid->toolTip().contains("does not allow"));
        }
        QVERIFY(!child<TabularDigitsLabel>("depthFigure")->isVisible());
        QVERIFY(!child<TabularDigitsLabel>("pulpFigure")->isVisible());
        press(Qt::Key_X);
        press(Qt::Key_F);
        QVERIFY(!section->isVisible() && !films->isVisible());
        QVERIFY2(child<TabularDigitsLabel>("decayFigure")->isVisible(), "what is no aid stays");
        // A section without the gauge tells no figures.
        forbid(&lessons::Aids::depthGauge);
        QCOMPARE(actions().section->toolTip(), tip);
        press(Qt::Key_X);
        QVERIFY(section->isVisible() && !child<TabularDigitsLabel>("sectionNearest")->isVisible());
        m_window->lessonController().setAids({});
        QVERIFY(child<TabularDigitsLabel>("sectionNearest")->isVisible() &&
                child<TabularDigitsLabel>("depthFigure")->isVisible());
        // Locked while it is looked at, the page of films closes.
        press(Qt::Key_F);
        QVERIFY(films->isVisible());
        m_window->lessonController().setAids(lessons::Aids::none());
        QVERIFY(!films->isVisible());
    }

    void figuresComeFromTheLoops()
    {
        ServoState servo;
        servo.tick = 5;
        servo.touching = true;
        servo.materialUnderBur = Material::Dentin;
        servo.forceN = {0.0, 0.6, 0.8};
        servo.depthMm = 1.417;
        servo.hasDepth = true;
        SessionState session;
        session.wholeMm3 = {20.0, 200.0, 250.0, 20.0};
        session.removedMm3 = {5.0, 12.314, 4.0, 0.001};
        session.pulpExposedMm2 = 0.058;
        session.overcutMm3 = 9.806;
        const auto areShown = [&](const QList<std::pair<const char*, const char*>>& figures) {
            take(servo, session);
            for (const auto& [name, text] : figures)
                QTRY_COMPARE(figure(name), QString::fromUtf8(text));
        };
        areShown({{"materialFigure", "Dentin"},
                  {"depthFigure", "1.42"},
                  {"forceFigure", "1.00"},
                  {"decayFigure", "75"},
                  {"enamelRemoved", "12.31"},
                  {"dentinRemoved", "4.00"},
                  {"pulpRemoved", "0.06"},
                  {"overcut", "9.81"}});
        servo.hasDepth = false;
        areShown({{"forceFigure", "1.00"}, {"depthFigure", "–"}});
        servo.touching = false;
        session.removedMm3[0] = 19.95;
        areShown({{"materialFigure", "Air"}, {"depthFigure", "–"}, {"decayFigure", "< 1"}});
        session.wholeMm3[0] = 0.0;
        areShown({{"decayFigure", "–"}});
        // The force is there and the bur touches nothing: it hangs beside the tooth.
        servo.handpieceOnCrown = true;
        areShown({{"materialFigure", "Handpiece"}});
        // A wall that presses is told.
        for (const auto& [sidewaysN, unit] : {std::pair(0.6, "N, 0.6 sideways"), {0.0, "N"}}) {
            servo.forceN = {sidewaysN, 0.0, 0.8};
            take(servo, session);
            QTRY_COMPARE(child<TabularDigitsLabel>("forceFigure")->unit(), QString(unit));
        }
    }

    void figuresWithoutAValueAreHidden()
    {
        ServoState servo;
        servo.tick = 5;
        const auto isShown = [&](const char* name) { return child<TabularDigitsLabel>(name)->isVisible(); };
        servo.anchorMm = {0.0, 0.0, -1.0};
        servo.touching = servo.hasDepth = true;
        take(servo, {});
        QTRY_VERIFY(isShown("pulpFigure"));
        QVERIFY(!isShown("marginFigure"));
        const int depthPx = child<TabularDigitsLabel>("depthFigure")->width();
        servo.anchorMm = {100.0, 100.0, 5.0};
        servo.touching = servo.hasDepth = false;
        take(servo, {});
        QTRY_VERIFY(!isShown("pulpFigure"));
        QCOMPARE(child<TabularDigitsLabel>("depthFigure")->width(), depthPx);
    }

    void aPracticeBlockHasNoEnamel()
    {
        beginLesson(support::assigned(lessons::Task::TraceShape));
        ServoState servo;
        servo.tick = 5;
        servo.touching = true;
        servo.materialUnderBur = Material::Enamel;
        SessionState session;
        session.removedMm3 = {0.0, 2.0, 1.0, 0.0};
        take(servo, session);
        QTRY_COMPARE(figure("materialFigure"), QString("Block"));
        QTRY_COMPARE(figure("enamelRemoved"), QString("3.00"));
        QVERIFY(!child<TabularDigitsLabel>("dentinRemoved")->isVisible());
        QVERIFY(!child<TabularDigitsLabel>("pulpFigure")->isVisible());
        beginLesson(lessons::practiceOn(support::syntheticMolar()).value());
        take(servo, session);
        QTRY_COMPARE(figure("materialFigure"), QString("Enamel"));
        QVERIFY(child<TabularDigitsLabel>("dentinRemoved")->isVisible());
    }

    void bursThatTheLessonForbidsAreGrey()
    {
        const auto& lesson = support::assigned(lessons::Task::TraceShape);
        const auto named = [&](QAction* bur) {
            const auto& ids = lesson.lesson->burs;
            return std::find(ids.begin(), ids.end(),
                             core::bur::burs()[static_cast<std::size_t>(actions().burs.indexOf(bur))].id) != ids.end();
        };
        const auto tiles = child<BurChooser>()->findChildren<BurTile*>();  // in the panel, and in the picker
        beginLesson(lesson);
        for (qsizetype k = 0; k < tiles.size(); ++k) {
            QAction* bur = actions().burs[static_cast<qsizetype>(core::bur::findBur(tiles[k]->bur().id).value())];
            QCOMPARE(tiles[k]->isEnabled(), named(bur));
            QCOMPARE(tiles[k]->toolTip().contains("does not allow"), !named(bur));
        }
        QVERIFY(std::any_of(tiles.begin(), tiles.end(), [](const BurTile* tile) { return !tile->isEnabled(); }));
        beginLesson(lessons::practiceOn(support::syntheticMolar()).value());
        for (const BurTile* tile : tiles)
            QVERIFY(tile->isEnabled() && !tile->toolTip().contains("does not allow"));
    }

    void theBursOfALessonAreAtHand()
    {
        const auto inPanel = [&] {
            QStringList ids;
            for (const BurTile* tile : child<BurChooser>()->findChildren<BurTile*>(Qt::FindDirectChildrenOnly))
                if (!tile->isHidden() && tile->isEnabled())
                    ids << QString::fromStdString(tile->bur().id);
            ids.sort();
            return ids;
        };
        const auto& lesson = support::assigned("first-03-buccal-pit-36");
        QCOMPARE(lesson.lesson->burs.front(), std::string("329"));
        beginLesson(lesson);
        QCOMPARE(inPanel(), (QStringList{"1", "2", "329", "330"}));
        const auto first = static_cast<qsizetype>(core::bur::findBur("329").value());
        QCOMPARE(actions().burs[first]->shortcut(), QKeySequence(Qt::Key_1));
        QVERIFY(!actions().burs[first]->toolTip().contains("does not allow"));
        QCOMPARE(actions().favouriteBurs(), (QList<int>{0, 1, 2, 3}));
        beginLesson(lessons::practiceOn(support::syntheticMolar()).value());
        QCOMPARE(actions().burs[0]->shortcut(), QKeySequence(Qt::Key_1));
    }

    void aNumberInFullIsThatBur()
    {
        auto* picker = m_window->findChild<BurPicker*>();
        QLineEdit* search = picker->findChild<QLineEdit*>("burSearch");
        for (const char* id : {"1", "2", "4", "33-1/2", "l"}) {
            press(Qt::Key_0);
            QTRY_VERIFY(search->hasFocus());
            const auto index = core::bur::findBur(id);
            QTest::keyClicks(search, id);
            spoil();
            QTest::keyClick(search, Qt::Key_Return);
            QTRY_VERIFY(!picker->isVisible());
            const auto commands = sent();
            QCOMPARE(commands.size(), std::size_t{1});
            if (index)
                QCOMPARE(std::size_t{std::get<SetBur>(commands.front()).index}, *index);
        }
    }

    void aBurThatIsNotAllowedIsSaidSo()
    {
        beginLesson(support::assigned(lessons::Task::TraceShape));
        press(Qt::Key_0);
        auto* picker = m_window->findChild<BurPicker*>();
        QLineEdit* search = picker->findChild<QLineEdit*>("burSearch");
        QTRY_VERIFY(search->hasFocus());
        const auto tiles = picker->findChildren<BurTile*>();
        const auto refused =
            std::find_if(tiles.begin(), tiles.end(), [](const BurTile* tile) { return !tile->isEnabled(); });
        QVERIFY(refused != tiles.end());
        QTest::keyClicks(search, QString::fromStdString((*refused)->bur().id));
        spoil();
        QTest::keyClick(search, Qt::Key_Return);
        QVERIFY(picker->isVisible());
        // The lesson gives its own first bur.
        const std::size_t index = core::bur::findBur((*refused)->bur().id).value();
        for (const auto& command : sent())
            QVERIFY(!std::holds_alternative<SetBur>(command) || std::get<SetBur>(command).index != index);
        QVERIFY(picker->findChild<QLabel*>("burNone")->isVisible());
        QTest::keyClick(search, Qt::Key_Escape);
        beginLesson(lessons::practiceOn(support::syntheticMolar()).value());
    }

    void anyBurIsFoundByItsNumber()
    {
        const auto index = core::bur::findBur("856").value();
        press(Qt::Key_0);
        auto* picker = m_window->findChild<BurPicker*>();
        QTRY_VERIFY(picker->isVisible());
        QLineEdit* search = picker->findChild<QLineEdit*>("burSearch");
        QTRY_VERIFY(search->hasFocus());
        const auto shown = [&] {
            QStringList ids;
            for (const BurTile* tile : picker->findChildren<BurTile*>())
                if (tile->isVisible())
                    ids << QString::fromStdString(tile->bur().id);
            ids.sort();
            return ids;
        };
        QCOMPARE(shown().size(), static_cast<qsizetype>(core::bur::burs().size()));
        QTest::keyClicks(search, "nothing like it");
        QVERIFY(shown().isEmpty());
        search->clear();
        QTest::keyClicks(search, "023");
        QCOMPARE(shown(), QStringList{"8"});
        search->clear();
        QTest::keyClicks(search, "806 314 237");
        QCOMPARE(shown(), QStringList{"830"});
        search->clear();
        QTest::keyClicks(search, "856");
        QCOMPARE(shown(), QStringList{"856"});
        spoil();
        QTest::keyClick(search, Qt::Key_Return);
        QTRY_VERIFY(!picker->isVisible());
        const auto commands = sent();
        QCOMPARE(commands.size(), std::size_t{1});
        QCOMPARE(std::size_t{std::get<SetBur>(commands.front()).index}, index);
        // What is in hand is in the panel, also if it is none of the favourites.
        const auto inPanel = [&] {
            QStringList ids;
            for (const BurTile* tile : child<BurChooser>()->findChildren<BurTile*>(Qt::FindDirectChildrenOnly))
                if (!tile->isHidden())
                    ids << QString::fromStdString(tile->bur().id);
            return ids;
        };
        QCOMPARE(inPanel(), (QStringList{"2", "330", "245", "57", "856"}));
        QVERIFY(actions().burs[static_cast<qsizetype>(index)]->isChecked());
        actions().burs[1]->trigger();
        QCOMPARE(inPanel(), (QStringList{"2", "330", "245", "57"}));
    }

    void favouriteBursAreAtHand()
    {
        actions().setFavouriteBurs({3, 27, 27, -1, 4000});
        QCOMPARE(actions().favouriteBurs(), (QList<int>{3, 27}));
        QCOMPARE(actions().burs[27]->shortcut(), QKeySequence(Qt::Key_2));
        QVERIFY(actions().burs[1]->shortcut().isEmpty());
        spoil();
        press(Qt::Key_2);
        const auto commands = sent();
        QCOMPARE(commands.size(), std::size_t{1});
        QCOMPARE(int{std::get<SetBur>(commands.front()).index}, 27);
        // A star takes one in and out; with four, no fifth.
        press(Qt::Key_0);
        auto* picker = m_window->findChild<BurPicker*>();
        QTRY_VERIFY(picker->isVisible());
        const auto starOf = [&](const char* id) -> QToolButton* {
            for (BurTile* tile : picker->findChildren<BurTile*>())
                if (tile->bur().id == id)
                    return tile->parentWidget()->findChild<QToolButton*>();
            return nullptr;
        };
        starOf("1/4")->click();
        starOf("860")->click();
        QCOMPARE(actions().favouriteBurs().size(), 4);
        QVERIFY(!starOf("330")->isEnabled() && starOf("860")->isEnabled());
        starOf("860")->click();
        QVERIFY(starOf("330")->isEnabled());
        // By keyboard: from the search down to the tiles and along them.
        QLineEdit* search = picker->findChild<QLineEdit*>("burSearch");
        search->setFocus();
        QTest::keyClick(search, Qt::Key_Down);
        auto* first = qobject_cast<BurTile*>(QApplication::focusWidget());
        QVERIFY(first != nullptr);
        QTest::keyClick(first, Qt::Key_Right);
        auto* second = qobject_cast<BurTile*>(QApplication::focusWidget());
        QVERIFY(second != nullptr && second != first);
        QTest::keyClick(second, Qt::Key_Escape);
        QTRY_VERIFY(!picker->isVisible());
        actions().setFavouriteBurs({0, 1, 2, 3});
    }

    void theBursFitASmallScreen()
    {
        spoil();
        m_window->resize(MainWindow::firstSize({1280, 800}));
        beginLesson(support::assigned("class1-36"));
        for (const BurTile* tile : child<BurChooser>()->findChildren<BurTile*>(Qt::FindDirectChildrenOnly))
            if (!tile->isHidden())
                QTRY_COMPARE(tile->visibleRegion().boundingRect(), tile->rect());
    }

    void harmIsToldWhenItHappens()
    {
        const auto* notice = child<QLabel>("notice");
        SessionState session;
        session.toothGeneration = m_generation;
        session.removedMm3[1] = 3.0;
        const auto told = [&](double pulpMm2, bool perforated) {
            session.pulpExposedMm2 = pulpMm2;
            session.perforated = perforated;
            take({}, session);
            return notice->isVisible() ? notice->text() : QString();
        };
        QCOMPARE(told(0.0, false), QString());
        QTRY_COMPARE(figure("enamelRemoved"), QString("3.00"));
        QCOMPARE(told(0.01, false), QString("Pulp opened"));
        QCOMPARE(told(0.01, true), QString("Tooth perforated"));
        QCOMPARE(told(0.0, false), QString());
        // Another tooth that comes with its harm done: an attempt that waited for a replay.
        session.toothGeneration = m_generation + 1;
        session.removedMm3[1] = 4.0;
        QCOMPARE(told(0.0, true), QString());
        QTRY_COMPARE(figure("enamelRemoved"), QString("4.00"));
        QVERIFY(!notice->isVisible());
    }

    void troubleIsTold()
    {
        const auto* sentence = child<QLabel>("health");
        const auto isTold = [&](std::uint32_t health, bool onCrown, bool touching) {
            ServoState servo;
            servo.tick = 1;
            servo.health = health;
            servo.handpieceOnCrown = onCrown;
            servo.touching = touching;
            take(servo, {});
            return sentence->isVisible() ? sentence->text() : QString();
        };
        QVERIFY(!sentence->isVisible());
        QTRY_VERIFY(isTold(kDeviceLost, false, false).contains("handpiece is disconnected"));
        QTRY_VERIFY(isTold(0, false, false).isEmpty());
        QTRY_VERIFY(isTold(0, true, false).startsWith("The handpiece touches the crown"));
        QTRY_VERIFY(isTold(0, true, true).isEmpty());
    }

    void errorsStayAndComeBackAfterNews()
    {
        const auto says = [this](const QString& words) {
            const auto labels = child<MessageBar>()->findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(),
                               [&](const QLabel* label) { return label->isVisible() && label->text() == words; });
        };
        m_window->showError({core::ErrorCode::FileTruncated, "molar.stl: ends after 84 bytes."},
                            FailedOperation::OpeningScan, "/scans/molar.stl");
        const QString error = message();
        QVERIFY(error.contains("ends too early") && says("molar.stl"));
        m_window->showMessage("Saved.");
        QCOMPARE(message(), QString("Saved."));
        press(Qt::Key_Escape);
        QCOMPARE(message(), error);
        press(Qt::Key_Escape);
        QVERIFY(message().isEmpty());
        // A lesson is mended by its teacher, who reads which and where.
        m_window->showError({core::ErrorCode::FileTruncated, "tooth.scan: a.stl is cut short"},
                            FailedOperation::OpeningLesson, "my-scan");
        QVERIFY(says("my-scan: tooth.scan: a.stl is cut short"));
    }

    void aWarningGoesWithItsReason()
    {
        const core::Error full{core::ErrorCode::FileUnwritable, "no room"};
        m_window->showError(full, FailedOperation::KeepingAttempt);
        QVERIFY2(message().contains("is not kept on the disk"), qPrintable(message()));
        m_window->showError(full, FailedOperation::SavingRecording);
        m_window->hideJournalError();
        QVERIFY2(message().contains("was not saved"), qPrintable(message()));
        child<MessageBar>()->dismiss();
        QVERIFY2(message().isEmpty(), qPrintable(message()));
        // Once the school has answered, what was said of its silence is over.
        m_window->showError({core::ErrorCode::ConnectionLost, "away"}, FailedOperation::ReadingSchool);
        m_window->showDatabaseSilent();
        QVERIFY2(message().contains("does not answer yet"), qPrintable(message()));
        m_window->hideDatabaseSilent();
        QVERIFY2(message().isEmpty(), qPrintable(message()));
    }

    void theMessageButtonDoesWhatItSays()
    {
        press(Qt::Key_R);
        QCOMPARE(sent().size(), std::size_t{1});
        QVERIFY(message().contains("was reset"));
        QTest::mouseClick(child<MessageBar>()->findChild<QPushButton*>(), Qt::LeftButton);
        const auto commands = sent();
        QCOMPARE(commands.size(), std::size_t{1});
        QVERIFY(std::holds_alternative<Undo>(commands.front()));
        QVERIFY(message().isEmpty());
    }

    void notesOfTheImporterAreShown()
    {
        const auto import = [this](const QStringList& said, bool unitInDoubt) {
            m_window->showTooth(
                support::syntheticMolar(), ++m_generation, [said] { return said; }, unitInDoubt);
        };
        import({"One."}, false);
        QCOMPARE(message(), QString("One."));
        import({"One.", "Two."}, false);
        QVERIFY(message().startsWith("2 note"));
        const auto* button = child<MessageBar>()->findChild<QPushButton*>();
        QVERIFY(!button->isVisible());
        // Another unit can be chosen beside the note.
        QSignalSpy chosen(m_window.get(), &MainWindow::scanUnitChosen);
        import({"Centimetres were taken."}, true);
        QVERIFY(button->isVisible() && button->menu() != nullptr);
        QCOMPARE(button->menu()->actions().size(), 5);
        button->menu()->actions().front()->trigger();
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen.front().front().toString(), QString("mm"));
        QVERIFY(!message().startsWith("Centimetres"));
        import({"Centimetres were taken."}, true);
        button->menu()->actions().back()->trigger();
        QCOMPARE(chosen.size(), 1);
        QVERIFY(!message().startsWith("Centimetres"));
    }

    void workIsShownAndHoldsBackTheRest()
    {
        auto* card = child<BusyOverlay>();
        m_window->showBusy("Loading the scan");
        QVERIFY(!actions().grade->isEnabled() && !actions().openScan->isEnabled());
        QTRY_VERIFY(card->isVisible());
        // An error of work in the background does not end it.
        m_window->showGradeNotSaved({core::ErrorCode::FileUnwritable, "x"});
        m_window->showJournalError({core::ErrorCode::FileUnwritable, "x"}, FailedOperation::KeepingAttempt);
        QVERIFY(card->isWorking() && m_window->isBusy());
        m_window->showError({core::ErrorCode::NoTriangles, "x"}, FailedOperation::OpeningScan);
        QVERIFY(!card->isVisible() && actions().openScan->isEnabled());
        m_window->showBusy("Again");
        show();
        QVERIFY(!card->isWorking() && actions().grade->isEnabled());
    }

    void helpListsEveryAction()
    {
        press(Qt::Key_F1);
        auto* help = child<HelpOverlay>();
        QVERIFY(help->isVisible());
        QSet<QString> words;
        for (const QLabel* label : help->findChildren<QLabel*>())
            words << label->text();
        for (const Actions::Group& group : actions().groups()) {
            QVERIFY2(words.contains(group.title()), qPrintable(group.title()));
            for (QAction* action : group.actions) {
                if (actions().burs.contains(action) && action->shortcuts().isEmpty())
                    continue;  // the picker shows those that are not at hand
                QVERIFY2(words.contains(action->text()), qPrintable(action->text()));
                for (const QKeySequence& key : action->shortcuts())
                    QVERIFY2(words.contains(key.toString(QKeySequence::NativeText)), qPrintable(action->text()));
            }
        }
        press(Qt::Key_F1);
        QVERIFY(!help->isVisible());
    }

    /// The tables of keys in docs/user-guide.md have the rows of F1, no more and no less.
    void userGuideHasTheKeysOfHelp()
    {
        QFile file(CUSP_SOURCE_DIR "/docs/user-guide.md");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString guide = QString::fromUtf8(file.readAll()).section("\n## Keys\n", 1).section("\n## ", 0, 0);
        QSet<QString> burNames;
        for (const QAction* bur : actions().burs)
            burNames << bur->text();
        QSet<QWidget*> rows;
        for (const QLabel* label : child<HelpOverlay>()->findChildren<QLabel*>())
            if (label->property("kind") == "key")
                rows << label->parentWidget();
        qsizetype others = 0;
        for (const QWidget* row : std::as_const(rows)) {
            QStringList words = labelTexts(*row);
            const QString name = words.takeFirst();
            if (burNames.contains(name))  // the guide has one row for the burs at hand
                continue;
            ++others;
            words.replaceInStrings(QRegularExpression("^,$"), "comma");
            words.replaceInStrings(QRegularExpression("^\\.$"), "full stop");
            const QString group = labelTexts(*row->parentWidget()).first();
            const QString table = guide.section("### " + group + '\n', 1).section("\n### ", 0, 0);
            const QString line = "\n| " + name + " | " + words.join(", ") + " |";
            QVERIFY2(table.contains(line), qPrintable(group + ':' + line));
        }
        QVERIFY(others > 50);
        static const QRegularExpression entry("\n\\| (?!action)");
        QCOMPARE(guide.count(entry), others + 1);
    }

    void everyActionIsFitToBeRead()
    {
        QSet<QString> keys;
        for (const Actions::Group& group : actions().groups())
            for (const QAction* action : group.actions) {
                QVERIFY(!action->text().isEmpty());
                QVERIFY2(!action->statusTip().isEmpty(), qPrintable(action->text()));
                QVERIFY2(action->toolTip().contains(action->shortcut().toString(QKeySequence::NativeText)),
                         qPrintable(action->toolTip()));
                QVERIFY2(!action->icon().isNull() || actions().burs.contains(action), qPrintable(action->text()));
                if (action == actions().pauseReplay || action == actions().along)
                    continue;  // rest while drill and bur colour, which have the same keys, do not
                for (const QKeySequence& key : action->shortcuts()) {
                    QVERIFY2(!keys.contains(key.toString()), qPrintable(key.toString() + " is taken twice"));
                    keys << key.toString();
                }
            }
    }

    void tabReachesEveryButtonOfTheRoom()
    {
        QSet<QWidget*> reached;
        for (int k = 0; k < 200; ++k) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            reached << QApplication::focusWidget();
        }
        for (QAbstractButton* button : child<PracticeRoom>()->findChildren<QAbstractButton*>())
            if (button->isVisible() && button->isEnabled())
                QVERIFY2(reached.contains(button), qPrintable(button->accessibleName()));
        QVERIFY(reached.contains(child<QSlider>("pushForce")) && reached.contains(&m_window->view()));
    }

    void escapeGoesBackStepByStep()
    {
        m_window->showError({core::ErrorCode::FileEmpty, "x"}, FailedOperation::OpeningScan);
        press(Qt::Key_T);
        press(Qt::Key_F1);
        QVERIFY(child<HelpOverlay>()->isVisible());
        press(Qt::Key_Escape);
        QVERIFY(!child<HelpOverlay>()->isVisible() && child<ToothChooser>()->isVisible());
        press(Qt::Key_Escape);
        QVERIFY(isInRoom() && !message().isEmpty());
        press(Qt::Key_Escape);
        QVERIFY(message().isEmpty());
        press(Qt::Key_Escape);
        QVERIFY(m_window->isVisible());
        QVERIFY2(sent().empty(), "going back never touches the work");
    }

    void theConsoleTakesKeysAndLeavesTheView()
    {
        auto* console = child<ui::console::Console>();
        QVERIFY(!console->isVisible());
        press(Qt::Key_F10);
        QTRY_VERIFY(console->isVisible());
        const auto* line = child<QLineEdit>("consoleLine");
        QCOMPARE(QApplication::focusWidget(), line);
        QTest::keyClicks(QApplication::focusWidget(), "d1r ");  // which would drill, take a bur and begin again
        QVERIFY(sent().empty());
        QCOMPARE(line->text(), QString("d1r "));
        // The mouse drills beneath it.
        auto& view = m_window->view();
        const QPoint below(view.width() / 2, view.height() * 3 / 4);
        QVERIFY(!console->geometry().contains(view.mapTo(console->parentWidget(), below)));
        press(Qt::Key_QuoteLeft);
        QTRY_VERIFY(!console->isVisible());
        QCOMPARE(line->text(), QString("d1r "));
        press(Qt::Key_QuoteLeft);
        QTRY_VERIFY(console->isVisible());
        press(Qt::Key_Escape);
        QTRY_VERIFY(!console->isVisible());
        QVERIFY(m_window->view().hasFocus());
    }

private:
    /// The aids that were noted last; nothing if none were since the last call.
    [[nodiscard]] std::optional<int> aidsNoted() const
    {
        frame();
        std::optional<int> last;
        for (const SessionCommand& c : allSent())
            if (const auto* aids = std::get_if<SetAids>(&c))
                last = aids->aids;
        return last;
    }
    /// Returns whether the last noted aids include this one, or nothing if no aids were noted since the last call.
    [[nodiscard]] std::optional<bool> isNoted(int aid) const
    {
        const auto noted = aidsNoted();
        return noted ? std::optional((*noted & aid) != 0) : std::nullopt;
    }
};

CUSP_TEST(TestWindowRoom)
#include "tst_window_room.moc"
