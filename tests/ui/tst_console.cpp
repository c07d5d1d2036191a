// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWidget>
#include <cmath>
#include <memory>

#include "core/servo/ServoState.h"
#include "tests/support/Suite.h"
#include "ui/console/Console.h"
#include "ui/console/Registration.h"
#include "ui/console/WatchPanel.h"
#include "ui/kit/Actions.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/presets/BlindTrial.h"
#include "ui/settings/SettingsPage.h"

using namespace ui;
using core::settings::FeelPreset;

namespace {

/// A console with the commands that the window registers, and a preset of its own.
struct Room
{
    QWidget window;
    FeelPreset feel;
    std::string refusal;
    QAction wet;
    console::Told told;
    core::servo::ServoState servo;
    console::PeriodMeter meter;
    core::settings::Parameters parameters;
    console::WatchPanel panel{parameters, &window};
    console::Console console{parameters, panel, &window};

    Room()
    {
        wet.setCheckable(true);
        wet.setText("Wet tooth");
        wet.setStatusTip("Let the tooth shine");
        console::registerFeel(
            parameters, [this] { return feel; }, [] { return FeelPreset{}; },
            [this](const FeelPreset& next) {
                if (refusal.empty())
                    feel = next;
                return refusal;
            });
        console::registerSwitch(parameters, "view.wet", &wet);
        console::registerLive(
            parameters, [this] { return servo; }, meter, [this] { return told; });
        window.resize(900, 600);
        console.resize(900, 300);
        window.show();
        console.open();
    }
    QLineEdit& line() { return *console.findChild<QLineEdit*>("consoleLine"); }
    std::unique_ptr<settings::SettingsPage> openSettings()
    {
        auto page = std::make_unique<settings::SettingsPage>(*new ui::kit::Actions(&window), parameters, &window);
        page->resize(900, 600);
        page->show();
        return page;
    }
    /// Returns the output of a command.
    QString answer(const QString& command)
    {
        auto* output = console.findChild<QPlainTextEdit*>("consoleOutput");
        output->clear();
        console.execute(command);
        return output->toPlainText().section('\n', 1);
    }
};

}  // namespace

class TestConsole : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Light); }

    void answersAreWrittenAsTheWindowWritesNumbers()
    {
        Room room;
        const QLocale before;
        QLocale::setDefault(QLocale("de_DE"));
        const QString german = room.answer("set force.stiffness 1,5");
        const QString again = room.answer("set force.stiffness 1.25");
        QLocale::setDefault(before);
        QCOMPARE(german, QString("force.stiffness = 1,5 N/mm"));
        QCOMPARE(again, QString("force.stiffness = 1,25 N/mm"));
        // The value is separated from a name of any length.
        for (const QString& line : room.answer("list hardness").split('\n'))
            QVERIFY2(line.contains("  "), qPrintable(line));
    }

    void everyNumberOfAPresetIsAParameter()
    {
        Room room;
        for (const char* name :
             {"hardness.enamel.rate", "hardness.enamel.threshold", "hardness.soft_caries.rate",
              "hardness.plastic.threshold", "hardness.axial_share", "hardness.flat_end_share", "hardness.full_load",
              "force.stiffness", "force.damping", "force.fast_damping", "force.friction", "force.limit"}) {
            const auto* parameter = room.parameters.find(name);
            QVERIFY2(parameter != nullptr, name);
            QVERIFY2(!parameter->help().empty() && !parameter->label().empty(), name);
            QVERIFY2(!parameter->isLive(), name);
        }
        std::size_t felt = room.parameters.beginningWith("hardness.").size();
        felt += room.parameters.beginningWith("force.").size();
        QCOMPARE(felt, core::settings::feelFields().size());
        for (const auto* live : room.parameters.beginningWith("live."))
            QVERIFY(live->isLive() && !live->help().empty());
    }

    void commandsAnswer()
    {
        for (const auto& [command, says] :
             {std::pair("get force.stiffness", "force.stiffness = 2 N/mm   (0.2 to 20 N/mm)"),
              {"force.stiffness", "force.stiffness = 2 N/mm"},
              {"set force.stiffness 2.5", "force.stiffness = 2.5 N/mm"},
              {"force.stiffness 2.5", "force.stiffness = 2.5 N/mm"},
              {"set force.stiffness 100", "force.stiffness takes 0.2 to 20 N/mm."},
              {"set force.stiffness hard", "\"hard\" is no number."},
              {"set force.stiffness on", "\"on\" is no number."},
              {"set force.stiffness nan", "force.stiffness takes"},
              {"set force.stiffness", "set NAME VALUE"},
              {"set nobody 1", "There is no parameter \"nobody\"."},
              {"set live.force 1", "live.force is a live value"},
              {"set view.wet on", "view.wet = on"},
              {"set view.wet 0.5", "view.wet takes 0 (off) or 1 (on)."},
              {"list stiff", "force.stiffness"},
              {"list xyz", "No parameter's name holds \"xyz\"."},
              {"get live.depth", "live.depth = –"},
              {"paint it", "There is no command \"paint\"."},
              {"watch", "\"watch\" wants a name"},
              {"help", "plot NAME"}}) {
            Room room;
            const QString said = room.answer(command);
            QVERIFY2(said.contains(says), qPrintable(command + QString(": ") + said));
        }
    }

    void whatIsFeltIsSetAndSetBack()
    {
        Room room;
        room.feel = {};
        room.feel.hash = std::string(64, 'a');
        room.answer("set hardness.enamel.rate 1.25");
        QCOMPARE(room.feel.enamelRate, 1.25);
        QVERIFY(room.feel.hash.empty());  // it differs from the saved version
        // A stiffness that is stable only with more damping is reset together with the damping, in either order.
        room.answer("set force.damping 15");
        room.answer("set force.stiffness 5.5");
        QCOMPARE(room.feel.stiffnessNPerMm, 5.5);
        const QString said = room.answer("reset");
        QVERIFY2(said.contains("as the preset says"), qPrintable(said));
        QVERIFY(room.feel == FeelPreset{});
        room.answer("set hardness.enamel.rate 1.25");
        QVERIFY(room.answer("reset hardness.enamel.rate").contains("hardness.enamel.rate = 0.7"));
    }

    void theOwnerMayRefuse()
    {
        Room room;
        room.refusal = "The hardness cannot be changed during an exam.";
        QVERIFY(room.answer("set force.stiffness 1").contains("during an exam"));
        QCOMPARE(room.feel.stiffnessNPerMm, 2.0);
        room.refusal.clear();
        // The limit for a stable stiffness still applies.
        const QString said = room.answer("set force.stiffness 9");
        QVERIFY2(said.contains("5.35 N/mm"), qPrintable(said));
        QCOMPARE(room.feel.stiffnessNPerMm, 2.0);
        room.wet.setEnabled(false);
        QVERIFY(room.answer("set view.wet 1").contains("cannot be changed"));
        QVERIFY(!room.wet.isChecked());
    }

    void tabCompletes()
    {
        Room room;
        for (const auto& [begun, becomes] : {std::pair("pl", "plot "),
                                             {"set force.s", "set force.stiffness "},
                                             {"get force.f", "get force.f"},
                                             {"get hard", "get hardness."},
                                             {"set dentin.rat", "set hardness.dentin.rate "},
                                             {"dentin.rat", "hardness.dentin.rate "},
                                             {"get rate", "get rate"},
                                             {"get xyz", "get xyz"},
                                             {"set force.stiffness 2", "set force.stiffness 2"}}) {
            room.line().clear();
            QCOMPARE(room.console.completed(begun), becomes);
            QTest::keyClicks(&room.line(), begun);
            QTest::keyClick(&room.line(), Qt::Key_Tab);
            QCOMPARE(room.line().text(), becomes);
            // The keys typed next must not act as shortcuts.
            QCOMPARE(room.line().window()->focusWidget(), static_cast<QWidget*>(&room.line()));
        }
    }

    void keysRecallAndClose()
    {
        Room room;
        QSignalSpy close(&room.console, &console::Console::closeRequested);
        for (const char* command : {"get force.limit", "help"}) {
            QTest::keyClicks(&room.line(), command);
            QTest::keyClick(&room.line(), Qt::Key_Return);
        }
        QTest::keyClick(&room.line(), Qt::Key_Up);
        QCOMPARE(room.line().text(), QString("help"));
        QTest::keyClick(&room.line(), Qt::Key_Up);
        QTest::keyClick(&room.line(), Qt::Key_Up);
        QCOMPARE(room.line().text(), QString("get force.limit"));
        QVERIFY(room.console.findChild<QLabel*>("consoleHint")->text().contains("8 N"));
        QTest::keyClick(&room.line(), Qt::Key_Down);
        QTest::keyClick(&room.line(), Qt::Key_Down);
        QVERIFY(room.line().text().isEmpty());
        QTest::keyClick(&room.line(), Qt::Key_QuoteLeft);
        QTest::keyClick(&room.line(), Qt::Key_Escape);
        QCOMPARE(close.size(), 2);
        QVERIFY(room.line().text().isEmpty());
    }

    void watchesAndPlots()
    {
        Room room;
        room.answer("watch force.stiffness");
        room.answer("plot live.force");
        QCOMPARE(room.panel.names(), (QStringList{"force.stiffness", "live.force"}));
        QVERIFY(room.panel.isVisible());
        QVERIFY(room.panel.testAttribute(Qt::WA_TransparentForMouseEvents));
        room.panel.forget("live.force");
        QVERIFY(room.panel.watch("live.force", true));
        // The plot holds ten seconds.
        const double begin = 1.0e6;
        for (int k = 0; k <= 300; ++k) {
            room.servo.forceN = glm::dvec3(0.0, 0.0, 0.01 * k);
            room.panel.sample(begin + 0.1 * k);
        }
        const auto values = room.panel.plotted("live.force");
        QCOMPARE(values.size(), std::size_t{101});
        QVERIFY(std::abs(values.front() - 2.0) < 1.0e-9 && std::abs(values.back() - 3.0) < 1.0e-9);
        QVERIFY(!room.panel.grab().isNull());
        // The plot can be saved in any language; without an extension it is saved as a table.
        const QTemporaryDir folder;
        QVERIFY(room.answer("export live.force " + folder.filePath("a force")).contains("a force.csv"));
        QFile table(folder.filePath("a force.csv"));
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = table.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), 102);
        QVERIFY2(lines[0].contains("live.force (N)") && lines[1].contains("-10,2") && lines.back().contains("0,3"),
                 (lines[0] + lines[1] + lines.back()).constData());
        QVERIFY(room.answer("export live.force " + folder.filePath("a force")).contains("already"));
        for (const char* name : {"force.svg", "force.png"})
            QVERIFY(room.answer("export live.force " + folder.filePath(name)).contains("Saved as") &&
                    QFileInfo(folder.filePath(name)).size() > 0);
        QVERIFY(room.answer("export live.force " + folder.filePath("none/a.csv")).contains("could not be written"));
        QVERIFY(room.answer("export force.stiffness a.csv").contains("is not plotted"));
        QVERIFY(room.answer("export live.force").contains("export NAME FILE"));
        for (const char* name :
             {"live.rpm", "live.removed", "live.depth", "live.missed", "live.period_p50", "live.period_p99"})
            room.answer(QStringLiteral("watch %1").arg(name));
        QVERIFY(room.answer("watch force.limit").contains("There is room for 8"));
        room.answer("unwatch live.depth");
        QVERIFY(!room.panel.names().contains("live.depth"));
        room.answer("unwatch");
        QVERIFY(room.panel.names().isEmpty() && !room.panel.isVisible());
    }

    void presetsAreKeptAndFelt()
    {
        Room room;
        QVERIFY(room.answer("save mine").contains("not to be had"));
        QStringList asked;
        room.console.setPresets(
            [&](const QString& name) {
                asked << "save " + name;
                return QString("kept");
            },
            [&](const QString& name) {
                asked << "load " + name;
                return QString("felt");
            },
            [] {
                return QStringList{"natural", "second year", "second year, soft", "Third"};
            });
        QVERIFY(room.answer("save second year").contains("kept"));
        QVERIFY(room.answer("load natural v1").contains("felt"));
        QCOMPARE(asked, (QStringList{"save second year", "load natural v1"}));
        // Names of presets may contain spaces.
        QCOMPARE(room.console.completed("load s"), "load second year");
        QCOMPARE(room.console.completed("load second year, "), "load second year, soft ");
        QCOMPARE(room.console.completed("save th"), "save Third ");
        QCOMPARE(room.console.completed("load x"), "load x");
    }

    void periodsAreThoseOfTheTrail()
    {
        console::PeriodMeter meter;
        QVERIFY(std::isnan(meter.percentileUs(0.5)));
        core::servo::ServoState state;
        std::int64_t now = 1'000'000'000;
        std::size_t next = 0;
        // Each frame has 16 poses, of which half were in the frame before. One period in fifty is three times as long.
        int tick = 0;
        for (int frame = 0; frame < 200; ++frame) {
            for (int k = 0; k < 8; ++k) {
                now += ++tick % 50 == 0 ? 3'000'000 : 1'000'000;
                state.trail[next++ % state.trail.size()].takenNs = now;
            }
            meter.take(state);
            meter.take(state);
        }
        QCOMPARE(meter.percentileUs(0.5), 1000.0);
        QCOMPARE(meter.percentileUs(0.97), 1000.0);
        QCOMPARE(meter.percentileUs(0.99), 3000.0);
    }

    void settingsPageIsTheRegistry()
    {
        Room room;
        const auto page = room.openSettings();
        for (const auto* parameter : room.parameters.matching({})) {
            const auto* input = page->findChild<QWidget*>(QString::fromStdString(parameter->name));
            QCOMPARE(input != nullptr, !parameter->isLive());
            if (input != nullptr)
                QVERIFY2(!input->accessibleName().isEmpty(), parameter->name.c_str());
        }
        auto* stiffness = page->findChild<QDoubleSpinBox*>("force.stiffness");
        QCOMPARE(stiffness->value(), 2.0);
        QCOMPARE(stiffness->maximum(), 20.0);
        stiffness->setValue(2.5);
        QCOMPARE(room.feel.stiffnessNPerMm, 2.5);
        QTest::mouseClick(page->findChild<QToolButton*>("reset force.stiffness"), Qt::LeftButton);
        QCOMPARE(stiffness->value(), 2.0);
        page->findChild<QCheckBox*>("view.wet")->click();
        QVERIFY(room.wet.isChecked());
        room.answer("set force.stiffness 1.5");
        page->refresh();
        QCOMPARE(stiffness->value(), 1.5);
        auto* search = page->findChild<QLineEdit*>("settingsSearch");
        search->setText("friction");
        QVERIFY(!stiffness->isVisible());
        QVERIFY(page->findChild<QWidget*>("force.friction")->isVisible());
        search->clear();
        QVERIFY(stiffness->isVisible());
        const auto* none = page->findChild<QLabel*>("noSetting");
        QVERIFY(!none->isVisible());
        search->setText("zzz");
        QVERIFY(none->isVisible());
        search->setText("lang");
        QVERIFY(!none->isVisible() && page->findChild<QComboBox*>("language")->isVisible());
        // The theme is saved for the next start.
        auto* theme = page->findChild<QComboBox*>("theme");
        theme->setCurrentIndex(2);
        emit theme->activated(2);
        QVERIFY(ui::kit::rememberedTheme() == ui::kit::ThemeChoice::Dark);
        theme->setCurrentIndex(0);
        emit theme->activated(0);
        QVERIFY(ui::kit::rememberedTheme() == ui::kit::ThemeChoice::System);
    }

    void settingsSayWhatIsRefused()
    {
        Room room;
        const auto page = room.openSettings();
        auto* stiffness = page->findChild<QDoubleSpinBox*>("force.stiffness");
        auto* fault = page->findChild<QLabel*>("settingsFault");
        stiffness->setValue(9.0);
        QVERIFY2(fault->isVisible() && fault->text().contains("5.35 N/mm"), qPrintable(fault->text()));
        QCOMPARE(stiffness->value(), 2.0);  // its current value
        stiffness->setValue(2.2);
        QVERIFY(!fault->isVisible());
    }

    void nothingIsToldWhileComparedBlind()
    {
        Room room;
        QString kept;
        room.console.setPresets([&](const QString& name) { return kept = name; }, {}, {});
        const FeelPreset known = room.feel;
        room.feel = presets::veiled(known);
        // The console reveals neither the value, nor whether it is this one, nor its distance from the bound.
        for (const char* command : {"get force.stiffness", "force.stiffness", "set force.stiffness 2",
                                    "set force.stiffness 9", "save leak", "reset force.stiffness"})
            QVERIFY2(room.answer(command).contains("blind comparison"), command);
        QVERIFY(kept.isEmpty());
        QVERIFY(room.answer("list force.stiff").contains("–"));
        room.line().setText("get force.stiffness");
        QVERIFY(room.console.findChild<QLabel*>("consoleHint")->text().startsWith("–"));
        const auto page = room.openSettings();
        auto* stiffness = page->findChild<QDoubleSpinBox*>("force.stiffness");
        QVERIFY(!stiffness->isEnabled() && !stiffness->text().contains('2'));
        const auto* why = page->findChild<QLabel*>("settingsBlind");
        QVERIFY2(why->isVisible() && why->text().contains("\"End the comparison\""), qPrintable(why->text()));
        room.feel = known;
        page->refresh();
        QVERIFY(!why->isVisible());
        QVERIFY(stiffness->isEnabled() && stiffness->value() == 2.0 && stiffness->text().contains("2.000"));
        QVERIFY(room.answer("get force.stiffness").contains("= 2 N/mm"));
    }

    void whatTheLessonForbidsIsNeitherToldNorWatched()
    {
        Room room;
        room.servo.hasDepth = true;
        room.servo.depthMm = 1.25;
        room.servo.removedMm3.fill(0.5);
        room.answer("plot live.depth");
        room.answer("watch live.removed");
        QVERIFY(room.answer("get live.depth").contains("1.25 mm"));
        QVERIFY(!room.panel.plotted("live.depth").empty());
        room.told = {false, false};
        const QTemporaryDir folder;
        for (const char* name : {"live.depth", "live.removed"})
            for (const QString command : {"get %1", "%1", "watch %1", "plot %1", "export %1 "})
                QCOMPARE(
                    room.answer(command.arg(name) + (command.startsWith("export") ? folder.filePath("a.csv") : "")),
                    QString("This lesson does not allow it."));
        QVERIFY(!QFileInfo::exists(folder.filePath("a.csv")));
        QVERIFY(room.answer("list live.depth").contains("–"));
        room.line().setText("get live.depth");
        QVERIFY(room.console.findChild<QLabel*>("consoleHint")->text().startsWith("–"));
        // Values watched before are no longer shown, including past ones.
        room.panel.sample(1.0e9);
        for (const double value : room.panel.plotted("live.depth"))
            QVERIFY(std::isnan(value));
        QVERIFY(room.answer("get live.force").contains("0 N"));
        room.told = {};
        room.panel.sample(1.0e9 + 0.1);
        QCOMPARE(room.panel.plotted("live.depth").back(), 1.25);
    }

    void answersAreSeenWhateverIsTyped()
    {
        Room room;
        room.console.resize(500, 160);
        auto* output = room.console.findChild<QPlainTextEdit*>("consoleOutput");
        const auto* bar = output->verticalScrollBar();
        for (int k = 0; k < 8; ++k) {
            // A long help text below takes a line from the output.
            QTest::keyClicks(&room.line(), "get hardness.enamel.rate");
            QApplication::processEvents();
            QTest::keyClick(&room.line(), Qt::Key_Return);
            QApplication::processEvents();
            QCOMPARE(bar->value(), bar->maximum());
        }
        // The Page Up and Page Down keys scroll the output.
        QTest::keyClick(&room.line(), Qt::Key_PageUp);
        QVERIFY(bar->value() < bar->maximum());
        QTest::keyClick(&room.line(), Qt::Key_PageDown);
        QCOMPARE(bar->value(), bar->maximum());
    }

    void numbersTakePointAndComma()
    {
        const auto isRead = [](const char* language, const char* typed, double becomes) {
            const QLocale before;
            QLocale::setDefault(QLocale(language));
            const std::unique_ptr<QDoubleSpinBox> number(
                ui::kit::numberInput(0.0, 10'000.0, 3, "mm³/(N s)", {}, nullptr));
            QLocale::setDefault(before);
            number->show();
            number->selectAll();
            QTest::keyClicks(number.get(), typed);
            QTest::keyClick(number.get(), Qt::Key_Return);
            QCOMPARE(number->value(), becomes);
            number->setValue(1000.5);
            QVERIFY2(number->text().startsWith("1000"), qPrintable(number->text()));
        };
        for (const char* language : {"en_GB", "de_DE", "es_ES", "ja_JP"})
            for (const char* typed : {"1.75", "1,75"})
                isRead(language, typed, 1.75);
        isRead("de_DE", "1.2,5", 1.25);
    }

    void whatIsBeyondTheRangeBecomesNoOtherNumber_data()
    {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<int>("decimals");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<bool>("isToldAtOnce");
        QTest::newRow("too much") << 0.2 << 20.0 << 3 << "25" << true;
        QTest::newRow("far too much") << 0.2 << 9.0 << 3 << "99" << true;
        QTest::newRow("a little too much") << 0.2 << 3.0 << 3 << "3.5" << true;
        QTest::newRow("too little") << 0.2 << 20.0 << 3 << "0.1" << false;
        QTest::newRow("too little so far") << 2.0 << 20.0 << 3 << "1" << false;
        QTest::newRow("below a negative range") << -2.0 << 20.0 << 3 << "-25" << true;
        QTest::newRow("no whole number") << 1.0 << 90.0 << 0 << "3.5" << true;
    }

    void whatIsBeyondTheRangeBecomesNoOtherNumber()
    {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(int, decimals);
        QFETCH(QString, typed);
        QFETCH(bool, isToldAtOnce);
        QWidget form;
        form.resize(400, 300);
        QDoubleSpinBox* number = ui::kit::numberInput(low, high, decimals, "N/mm", {}, &form);
        number->setValue(2.0);
        form.show();
        QVERIFY(QTest::qWaitForWindowActive(&form));
        const auto said = [&form] {
            const auto* note = form.findChild<QLabel*>("numberNote");
            return note != nullptr && note->isVisible() ? note->text() : QString();
        };
        number->setFocus();
        number->selectAll();
        QTest::keyClicks(number, typed);
        QVERIFY2(number->text().startsWith(typed), qPrintable(number->text()));
        QCOMPARE(number->value(), 2.0);
        QCOMPARE(!said().isEmpty(), isToldAtOnce);
        QTest::keyClick(number, Qt::Key_Return);
        QCOMPARE(number->value(), 2.0);
        QVERIFY2(number->text().startsWith("2"), qPrintable(number->text()));
        QVERIFY2(said().contains(QLocale().toString(high) + " N/mm can be entered here.") &&
                     said().endsWith("N/mm stays."),
                 qPrintable(said()));
        // A value in range is accepted without a message.
        number->selectAll();
        QTest::keyClicks(number, "3");
        QTest::keyClick(number, Qt::Key_Return);
        QCOMPARE(number->value(), 3.0);
        QVERIFY2(said().isEmpty(), qPrintable(said()));
        // A partly typed value is discarded when the field loses the focus.
        number->selectAll();
        QTest::keyClicks(number, typed);
        number->clearFocus();
        QCOMPARE(number->value(), 3.0);
        QVERIFY2(number->text().startsWith("3"), qPrintable(number->text()));
        QVERIFY2(said().contains("3.000 N/mm stays.") || decimals == 0, qPrintable(said()));
        number->stepUp();
        QVERIFY2(number->value() > 3.0 || high == 3.0, qPrintable(number->text()));
    }
};

CUSP_TEST(TestConsole)
#include "tst_console.moc"
