// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScopeGuard>
#include <QSlider>
#include <QSpinBox>
#include <QTest>

#include "core/recording/Replay.h"
#include "core/servo/ServoParameters.h"
#include "lessons/PresetFile.h"
#include "tests/app/ProgramWindow.h"
#include "tests/support/Files.h"
#include "tests/support/OpenGlMain.h"
#include "tests/support/Solids.h"
#include "ui/console/Console.h"
#include "ui/kit/MessageBar.h"
#include "ui/presets/PresetsPage.h"
#include "ui/presets/TrialCard.h"
#include "ui/tooth/ToothView.h"

using support::kPatienceMs;

/// How drilling feels, from the page and the console down to the servo and the recording.
class TestFeel : public support::ProgramWindow
{
    Q_OBJECT
private slots:
    void init()
    {
        QLocale::setDefault(QLocale("en_GB"));
        m_folder = std::make_unique<QTemporaryDir>();
        qputenv("XDG_DATA_HOME", m_folder->path().toLocal8Bit());
    }

    void cleanup() { m_application.reset(); }

    /// The preset is tried on a block that is drilled by the same rules as a tooth.
    void aPresetIsTriedOnABlockAndKept()
    {
        start();
        QVERIFY(recording().settings().hardness.name.starts_with("natural v2 #"));
        openPresets();
        tryOnBlock("presetTry");
        auto* card = child<ui::presets::TrialCard>();
        QVERIFY(card->isVisible());
        QVERIFY(!recording().isRetuned());
        // Rates of caries and enamel, as the servo is told them.
        const auto rates = [this] {
            const core::recording::Recording made = recording();
            core::servo::ServoSettings settings = made.settings();
            made.forEach([&](const core::servo::ServoEvent& event) {
                if (event.kind != core::servo::ServoEvent::Kind::Number)
                    return;
                if (const auto number = core::servo::unpackParameter(event.value))
                    core::servo::setServoNumber(settings, *number);
            });
            return std::pair(static_cast<float>(settings.hardness.material[0].rateMm3PerNs),
                             static_cast<float>(settings.hardness.material[1].rateMm3PerNs));
        };
        const auto of = [](double caries, double enamel) {
            return std::pair(static_cast<float>(caries), static_cast<float>(enamel));
        };
        auto* block = card->findChild<QComboBox*>("trialBlock");
        QVERIFY(block->isVisible() && block->count() == 3);
        const auto choose = [block](int index) {
            block->setCurrentIndex(index);
            emit block->activated(index);
        };
        const core::settings::FeelPreset preset = lessons::shippedPresets().front();
        WAIT_FOR_VALUE(rates(), of(preset.softCariesRate, preset.enamelRate));
        choose(2);
        WAIT_FOR_VALUE(rates(), of(preset.plasticRate, preset.plasticRate));
        choose(1);
        WAIT_FOR_VALUE(rates(), of(preset.firmCariesRate, preset.enamelRate));
        // A slider is felt at once, on each of them: it is on the recording, and replays to the bit.
        auto* enamel = card->findChild<QSlider*>("dial0");
        enamel->setValue(enamel->maximum());
        WAIT_FOR_VALUE(rates(), of(preset.firmCariesRate, 0.175));
        choose(0);
        WAIT_FOR_VALUE(rates(), of(preset.softCariesRate, 0.175));
        QVERIFY(recording().isRetuned());
        const auto replayed = core::recording::replay(recording());
        QVERIFY(replayed && replayed->agreesWithWitness);
        QTest::mouseClick(card->findChild<QPushButton*>("trialBack"), Qt::LeftButton);
        waitForPage<ui::presets::PresetsPage>();
        QCOMPARE(page().draft().enamelRate, 0.175);
        QCOMPARE(child<ui::presets::PresetsPage>()->findChild<QSlider*>("dial0")->value(), enamel->maximum());
        click("presetSave");
        QCOMPARE(page().draft().version, 3);
        QVERIFY(message().contains("natural, version 3"));
        auto* list = child<QListWidget>("presetList");
        QVERIFY(list->count() == 3 && !list->item(0)->text().contains("shipped"));
        click("presetUse");
        chooseTooth(26);
        QVERIFY(!card->isVisible());
        QVERIFY(recording().settings().hardness.name.starts_with("natural v3 #"));
        QCOMPARE(recording().settings().hardness.material[1].rateMm3PerNs, 0.175);
        // The next start finds what is in use.
        m_application.reset();
        start();
        QVERIFY(recording().settings().hardness.name.starts_with("natural v3 #"));
        emit window().hardness().useRequested(lessons::shippedPresets().front());
    }

    void whatIsTurnedByHandIsNamedAndHoldsForTheNextTooth()
    {
        start();
        actions().console->trigger();
        WAIT_FOR(child<ui::console::Console>()->isVisible());
        QVERIFY(answer("set hardness.enamel.rate 5").contains("= 5 mm"));
        WAIT_FOR(recording().isRetuned());
        QVERIFY(used().isChanged);
        chooseTooth(26);
        const core::recording::Recording next = recording();
        QVERIFY(!next.isRetuned());
        QCOMPARE(next.settings().hardness.material[1].rateMm3PerNs, 5.0);
        QVERIFY((lessons::presetUsed(next) == lessons::PresetUsed{"natural", 2, {}, true}));
        QVERIFY2(answer("save mine").contains("mine, version 1"), qPrintable(answer("help")));
        QVERIFY(answer("reset").contains("as the preset says"));
        chooseTooth(36);
        QVERIFY(!used().isChanged);
        QVERIFY(answer("load mine").contains("mine, version 1"));
        // Nothing is cut yet: the attempt is made with it from the beginning.
        WAIT_FOR_VALUE(used().name, QString("mine"));
        QVERIFY(!used().isChanged);
        QVERIFY(answer("reset").contains("as the preset says"));
        WAIT_FOR_VALUE(used().name, QString("natural"));
        QVERIFY(!used().isChanged);
        QVERIFY(answer("load mine").contains("mine, version 1"));
        chooseTooth(26);
        QCOMPARE(used().name, QString("mine"));
        QVERIFY(!used().isChanged);
        QTest::keyClick(child<QLineEdit>("consoleLine"), Qt::Key_Escape);
        WAIT_FOR(!child<ui::console::Console>()->isVisible());
    }

    void whatAScanAsksStaysAskedWhenAPresetIsLoaded()
    {
        start();
        // A millimetre wide, it can be no tooth in millimetres.
        const QString scan = m_folder->filePath("cap.stl");
        support::write(scan, support::asBinaryStl(support::sphereCap(0.5F, 0.5F, 40, 10)));
        const auto isAsked = [this] {
            for (const QPushButton* button : child<ui::kit::MessageBar>()->findChildren<QPushButton*>())
                if (button->isVisible() && button->text() == "Another unit")
                    return true;
            return false;
        };
        emit window().scanChosen(scan);
        WAIT_FOR(isAsked());
        const core::settings::FeelPreset& other = lessons::shippedPresets().front();
        emit window().hardness().feelRequested(other);
        WAIT_FOR_VALUE(used().name, QString::fromStdString(other.name));
        QVERIFY(!used().isChanged);
        child<ui::kit::MessageBar>()->dismiss();  // that the recording was saved
        QVERIFY2(isAsked(), qPrintable(message()));
    }

    void twoPresetsAreComparedBlind()
    {
        start();
        core::settings::FeelPreset hard;
        hard.name = "hard";
        hard.enamelRate = 0.2;
        emit window().hardness().saveRequested(hard);
        actions().presets->trigger();
        child<QComboBox>("presetOther")->setCurrentIndex(child<QComboBox>("presetOther")->findText("natural v1"));
        child<QSpinBox>("presetTrials")->setValue(2);
        tryOnBlock("presetCompare");
        auto* card = child<ui::presets::TrialCard>();
        QVERIFY(card->isVisible() && !card->tuned());
        QVERIFY(answer("set force.friction 0.2").contains("blind comparison"));
        for (const char* command : {"get force.friction", "save leak", "set force.stiffness 19"})
            QVERIFY2(answer(command).contains("blind comparison"), command);
        ui::tooth::ToothView& view = window().view();
        QTest::mouseMove(&view, view.rect().center());
        QTest::mousePress(&view, Qt::LeftButton, {}, view.rect().center());
        WAIT_FOR(actions().undo->isEnabled());
        QTest::mouseRelease(&view, Qt::LeftButton, {}, view.rect().center());
        waitForStrokeEnd();
        // It is nobody's work, and is not offered to be gone on with.
        QCOMPARE(QDir(m_folder->filePath("unfinished")).entryList({"*.cuspjournal"}, QDir::Files), QStringList());
        QVERIFY(!actions().grade->isEnabled());
        const auto cutWith = [card](const char* letter) {
            QTest::mouseClick(card->findChild<QPushButton*>(letter), Qt::LeftButton);
            card->follow(1, 0, 0.0);
            card->follow(1, 0, 0.1);
        };
        cutWith("trialA");
        cutWith("trialB");
        WAIT_FOR(recording().isRetuned());
        QTest::mouseClick(card->findChild<QPushButton*>("trialSaysA"), Qt::LeftButton);
        QVERIFY(!card->findChild<QPushButton*>("trialSaysNone")->isEnabled());
        cutWith("trialA");
        cutWith("trialB");
        QTest::mouseClick(card->findChild<QPushButton*>("trialSaysNone"), Qt::LeftButton);
        QVERIFY(card->findChild<QPushButton*>("trialCsv")->isVisible());
        QVERIFY(card->findChild<QLabel*>("trialWords")->text().contains("No difference: 1 time"));
    }

    void whatIsWrongWithAFileStaysToBeRead()
    {
        start();
        actions().presets->trigger();
        const auto import = [this](const char* json) {
            const QString path = m_folder->filePath("slip.json");
            support::write(path, json);
            emit window().hardness().importRequested(path);
        };
        auto* fault = child<QLabel>("presetFault");
        import(R"({"name": "slip", "enamell": {"rate_mm3_per_ns": 3}})");
        WAIT_FOR_VALUE(page().draft().name, std::string("slip"));
        QVERIFY2(fault->text().contains("slip.json, enamell: ") && fault->text().contains("did you mean \"enamel\"?"),
                 qPrintable(fault->text()));
        const QString detail = child<QLabel>("presetFaultDetail")->text();
        QVERIFY2(detail.contains("says nothing of ") && detail.contains("pulp"), qPrintable(detail));
        const auto* bar = child<ui::kit::MessageBar>();
        QVERIFY2(bar->sentence().contains("was saved: slip"), qPrintable(bar->sentence()));
        import(R"({"force": {"stiffness_n_per_mm": 15}})");
        QVERIFY2(!bar->sentence().contains("was saved"),
                 qPrintable(bar->sentence()));  // one would read the older of both
        QVERIFY2(fault->text().contains("Would tremble"), qPrintable(fault->text()));
        core::settings::FeelPreset stiff;
        stiff.name = "stiff";
        stiff.version = 0;
        stiff.stiffnessNPerMm = 15.0;
        emit window().hardness().saveRequested(stiff);
        QVERIFY2(fault->text().contains("Not kept: Would tremble"), qPrintable(fault->text()));
    }

    void anExamFeelsAsItShould()
    {
        start();
        QVERIFY(answer("set force.friction 0.2").contains("0.2"));
        openMadeLesson(
            R"({"format": 1, "based_on": "decay-36-2-moderate.lesson.json", "id": "exam-36", "exam": true})");
        WAIT_FOR(answer("set force.friction 0.3").contains("during an exam"));
        const core::recording::Recording exam = recording();
        QCOMPARE(exam.settings().force.friction, core::contact::ForceSettings{}.friction);
        QVERIFY(!lessons::presetUsed(exam).isChanged);
        QVERIFY(!exam.isRetuned());
    }

    /// In the folder that the desktop keeps for the data of programs.
    void withoutAFileTheDataAreTheUsersOwn()
    {
        const QString name = QCoreApplication::applicationName();
        const auto back = qScopeGuard([&name] { QCoreApplication::setApplicationName(name); });
        QCoreApplication::setApplicationName("cusp");
        app::WindowOptions options;
        options.source = {36};
        m_application = app::Application::make(options).value();
        m_application->show();
        WAIT_FOR(QFile::exists(m_folder->filePath("cusp/cusp.sqlite")));
    }

private:
    [[nodiscard]] ui::presets::PresetsPage& page() const { return *child<ui::presets::PresetsPage>(); }

    void openPresets() const
    {
        actions().presets->trigger();
        waitForPage<ui::presets::PresetsPage>();
    }

    void start()
    {
        app::WindowOptions options;
        options.source = {36};
        begin(options);
        waitForTooth("Tooth 36", [] {});
    }

    /// Does what puts this tooth on the table, and waits until the servo has it.
    void waitForTooth(const QString& title, const std::function<void()>& change) const
    {
        const std::uint64_t before = servo().toothGeneration;
        change();
        WAIT_FOR(window().windowTitle().startsWith(title));
        WAIT_FOR(actions().chooseTooth->isEnabled() && servo().toothGeneration > before);
    }

    void chooseTooth(int fdi) const
    {
        waitForTooth(QStringLiteral("Tooth %1").arg(fdi), [this, fdi] { emit window().toothChosen(fdi); });
    }
    void tryOnBlock(const char* button) const
    {
        waitForTooth("Practice block", [this, button] { click(button); });
    }

    [[nodiscard]] core::recording::Recording recording() const
    {
        const QString path = m_folder->filePath("now.cusprec");
        QFile::remove(path);
        emit window().unsavedWork().recordingSaveRequested(path);
        if (!QTest::qWaitFor([&] { return QFile::exists(path); }, kPatienceMs))
            qFatal("no recording");
        return core::recording::readRecording(path.toStdString()).value();
    }

    /// The preset that the present attempt is made with.
    [[nodiscard]] lessons::PresetUsed used() const { return lessons::presetUsed(recording()); }

    [[nodiscard]] QString answer(const QString& command) const
    {
        auto* output = child<QPlainTextEdit>("consoleOutput");
        output->clear();
        child<ui::console::Console>()->execute(command);
        return output->toPlainText().section('\n', 1);
    }
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestFeel>(argc, argv);
}
#include "tst_feel.moc"
