// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTranslator>

#include "core/settings/StabilityBound.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/Suite.h"
#include "tests/ui/PageTest.h"
#include "ui/charts/SaveButton.h"
#include "ui/presets/BlindTrial.h"
#include "ui/presets/FeedChart.h"
#include "ui/presets/PresetsPage.h"
#include "ui/presets/SimpleFeel.h"
#include "ui/presets/TrialCard.h"
#include "ui/text/PresetTexts.h"

using namespace ui;
using core::settings::FeelPreset;
using presets::BlindTrial;
using presets::Dial;
using presets::Dials;

Q_DECLARE_METATYPE(core::settings::FeelPreset)

namespace {

FeelPreset presetNamed(const char* name, int version, double enamelRate)
{
    FeelPreset preset;
    preset.name = name;
    preset.version = version;
    preset.enamelRate = enamelRate;
    return lessons::hashed(preset);
}

const FeelPreset& shipped()
{
    return lessons::shippedPresets().front();
}

std::vector<lessons::ReadPreset> shelf()
{
    return {{"/a", presetNamed("hard", 2, 0.4), {}},
            {"/b", presetNamed("hard", 1, 0.5), {}},
            {{}, shipped(), {}},
            {"/bad.cusppreset", {}, {{"/bad.cusppreset", {}, {"is empty"}, true}}}};
}

Dials dials(Dial which, double turn)
{
    Dials all{};
    all.at(static_cast<std::size_t>(which)) = turn;
    return all;
}

}  // namespace

class TestPresetsPage : public support::PageTest<presets::PresetsPage>
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        prepare();
        qRegisterMetaType<FeelPreset>();
    }
    void init()
    {
        openPage();
        m_page->setPresets(shelf(), shipped());
    }

    void dialsTurnWhatTheySay()
    {
        const FeelPreset base;
        QVERIFY(presets::turned(base, {}) == base);
        QCOMPARE(presets::turned(base, dials(Dial::Enamel, 1.0)).enamelRate, 0.175);
        QCOMPARE(presets::turned(base, dials(Dial::Enamel, -1.0)).enamelRate, 2.8);
        const FeelPreset harder = presets::turned(base, dials(Dial::Caries, 0.5));
        QCOMPARE(harder.softCariesRate, 2.5);
        QCOMPARE(harder.firmCariesRate, 1.6);
        QCOMPARE(harder.dentinRate, base.dentinRate);
        QCOMPARE(presets::turned(base, dials(Dial::Touch, 1.0)).enamelFromN, 0.6);
        QCOMPARE(presets::turned(base, dials(Dial::Wall, -1.0)).stiffnessNPerMm, 1.0);
    }

    void dialsAreFoundAgain()
    {
        const FeelPreset base;
        for (int step = -presets::kDialSteps; step <= presets::kDialSteps; ++step) {
            presets::Dials all{};
            for (std::size_t k = 0; k < presets::kDials; ++k)
                all[k] = static_cast<double>((step * static_cast<int>(k + 1)) % (presets::kDialSteps + 1)) /
                         presets::kDialSteps;
            const FeelPreset there = presets::turned(base, all);
            const auto found = presets::dialsFor(base, there);
            QVERIFY(found);
            QVERIFY(presets::turned(base, *found) == there);
        }
        FeelPreset byHand = base;
        byHand.dentinRate = 1.234;
        QVERIFY(!presets::dialsFor(base, byHand));
    }

    void noDialGoesBeyondTheBound()
    {
        for (const double damping : {0.0, 3.0, 20.0})
            for (const double stiffness : {0.3, 1.0, 2.0}) {
                FeelPreset base;
                base.dampingNSPerM = damping;
                base.fastDampingNSPerM = damping;
                base.stiffnessNPerMm = stiffness;
                const FeelPreset stiffest = presets::turned(base, dials(Dial::Wall, 1.0));
                if (core::settings::checkStability(base))
                    QVERIFY(core::settings::checkStability(stiffest));
                else
                    QCOMPARE(stiffest.stiffnessNPerMm, base.stiffnessNPerMm);
            }
    }

    void binomialIsExact()
    {
        for (const auto& [hits, of, p] : {std::tuple(0, 1, 1.0),
                                          {4, 8, 1.0},
                                          {8, 8, 2.0 / 256.0},
                                          {0, 8, 2.0 / 256.0},
                                          {7, 8, 18.0 / 256.0},
                                          {2, 10, 112.0 / 1024.0}})
            QVERIFY(support::near(presets::binomialP(hits, of), p));
    }

    void blindTrialCountsWhatWasBehindTheLetters()
    {
        const FeelPreset first = presetNamed("a, \"b\"", 1, 0.5);
        const FeelPreset second = presetNamed("plain", 2, 0.7);
        int asA = 0;
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            BlindTrial trial(first, second, 10, seed);
            while (!trial.isOver()) {
                const bool firstIsA = trial.behind(BlindTrial::Answer::A) == first;
                QVERIFY(trial.behind(BlindTrial::Answer::B) == (firstIsA ? second : first));
                asA += firstIsA ? 1 : 0;
                trial.answer(trial.trial() > 8 ? BlindTrial::Answer::NoDifference
                             : firstIsA        ? BlindTrial::Answer::A
                                               : BlindTrial::Answer::B);
            }
            trial.answer(BlindTrial::Answer::A);  // the trial is over
            const BlindTrial::Outcome outcome = trial.outcome();
            QVERIFY(outcome.first == 8 && outcome.second == 0 && outcome.neither == 2);
            QVERIFY(support::near(outcome.p, 2.0 / 256.0));
            const QList<QByteArray> lines = trial.csv().trimmed().split('\n');
            QCOMPARE(lines.size(), 11);
            QCOMPARE(lines.front(), QByteArray("trial,behind_a,behind_b,answer,chosen"));
            QVERIFY2(lines[1].contains("\"a, \"\"b\"\" v1 #"), lines[1]);
        }
        QVERIFY(asA > 150 && asA < 250);  // of 400
    }

    void listsEveryVersionAndWhatIsWrong()
    {
        auto* save = child<QPushButton>("presetSave");
        QCOMPARE(list().count(), 4);
        QVERIFY(list().item(0)->text().contains("version 2"));
        QVERIFY(list().item(2)->text().contains("shipped") && list().item(2)->text().contains("in use"));
        QVERIFY(!(list().item(3)->flags() & Qt::ItemIsSelectable) && list().item(3)->text().contains("is empty"));
        QCOMPARE(list().currentRow(), 2);  // the one in use
        QVERIFY(!isEnabled("presetUse"));
        list().setCurrentRow(0);
        QVERIFY(!save->isEnabled());
        list().setCurrentRow(1);
        QVERIFY(m_page->draft() == presetNamed("hard", 1, 0.5));
        QVERIFY(save->isEnabled() && save->text().startsWith("Restore"));  // an older version
        QSignalSpy use(m_page, &presets::PresetsPage::useRequested);
        click("presetUse");
        QCOMPARE(use.size(), 1);
    }

    void aChangedNumberCanBeTriedAndKept()
    {
        QSignalSpy tried(m_page, &presets::PresetsPage::tryRequested);
        QSignalSpy saved(m_page, &presets::PresetsPage::saveRequested);
        QVERIFY(!isEnabled("presetSave"));
        click("presetExpert");
        spin("enamel.rate_mm3_per_ns")->setValue(0.6);
        QCOMPARE(m_page->draft().enamelRate, 0.6);
        QVERIFY(textOf("presetVersion").contains("changed from natural, version 2"));
        click("presetTry");
        QCOMPARE(tried.size(), 1);
        QCOMPARE(tried[0][0].value<FeelPreset>().enamelRate, 0.7);
        QCOMPARE(tried[0][1].value<FeelPreset>().enamelRate, 0.6);
        QVERIFY(!isEnabled("presetExport"));  // only a saved version can be exported
        click("presetSave");
        QCOMPARE(saved[0][0].value<FeelPreset>().version, 0);
        QCOMPARE(saved[0][0].value<FeelPreset>().name, std::string("natural"));
    }

    void whatIsNotHeldCanNeitherBeTriedNorKept()
    {
        QVERIFY(textOf("presetBound").startsWith("Holds"));
        click("presetExpert");
        spin("force.stiffness_n_per_mm")->setValue(8.0);
        const QString said = textOf("presetBound");
        QVERIFY2(said.contains("5.35 N/mm") && said.contains("8.00"), qPrintable(said));
        QVERIFY(!isEnabled("presetTry"));
        QVERIFY(!isEnabled("presetSave"));
        spin("force.stiffness_n_per_mm")->setValue(3.0);
        QVERIFY(isEnabled("presetSave"));
        spin("force.limit_n")->setValue(12.0);
        QVERIFY(textOf("presetBound").contains("8.9 N"));
        QVERIFY(!isEnabled("presetSave"));
    }

    void slidersAndNumbersAreOnePreset()
    {
        auto* slider = child<QSlider>("dial0");
        slider->setValue(slider->maximum());
        QCOMPARE(m_page->draft().enamelRate, 0.175);
        click("presetExpert");
        QCOMPARE(spin("enamel.rate_mm3_per_ns")->value(), 0.175);
        spin("dentin.rate_mm3_per_ns")->setValue(1.0);
        click("presetSimple");
        QCOMPARE(slider->value(), 0);  // no slider position gives these values
        slider->setValue(slider->minimum());
        // The sliders keep their positions when the panels are switched, and after a trial.
        for (int round = 0; round < 3; ++round) {
            click("presetExpert");
            click("presetSimple");
            m_page->setDraft(FeelPreset(m_page->draft()));
        }
        QCOMPARE(m_page->draft().enamelRate, 0.7);
        QCOMPARE(m_page->draft().dentinRate, 1.0);
    }

    void slidersStandWhereTheVersionStands()
    {
        auto* wall = child<QSlider>("dial5");
        QCOMPARE(textOf("dialMiddle"), QString("In the middle: natural, version 2."));
        auto all = shelf();
        const auto keep = [&](int version) {
            FeelPreset kept = m_page->draft();
            kept.version = version;
            kept = lessons::hashed(kept);
            all.push_back({"/c", kept, {}});
            m_page->setPresets(all, shipped());
            m_page->select(kept);
        };
        wall->setValue(wall->minimum());
        keep(3);
        QVERIFY(textOf("presetVersion").startsWith("version 3"));
        QCOMPARE(wall->value(), wall->minimum());  // at its softest, and unchanged by saving again
        QCOMPARE(textOf("dialMiddle"), QString("In the middle: natural, version 2."));
        wall->setValue(0);
        QCOMPARE(m_page->draft().stiffnessNPerMm, shipped().stiffnessNPerMm);
        QVERIFY(textOf("presetVersion").contains("changed from natural, version 3"));
        // Values that no slider position gives are shown as the middle position. When saved, they get a version.
        click("presetExpert");
        spin("dentin.rate_mm3_per_ns")->setValue(1.234);
        click("presetSimple");
        QVERIFY2(textOf("dialMiddle").contains("typed"), qPrintable(textOf("dialMiddle")));
        keep(4);
        QCOMPARE(textOf("dialMiddle"), QString("In the middle: natural, version 4."));
        wall->setValue(5);
        keep(5);
        QCOMPARE(textOf("dialMiddle"), QString("In the middle: natural, version 4."));
        QCOMPARE(wall->value(), 5);
    }

    void whatIsInUseIsShownUntilAnotherIsLookedAt()
    {
        const auto shown = [&] { return list().currentItem()->text(); };
        QVERIFY2(shown().contains("natural") && shown().contains("in use"), qPrintable(shown()));
        // A user logs in whose school uses another preset.
        m_page->setPresets(shelf(), *shelf()[0].preset);
        QVERIFY2(shown().contains("hard") && shown().contains("version 2"), qPrintable(shown()));
        QCOMPARE(child<QLineEdit>("presetName")->text(), QString("hard"));
        // If the user is looking at another preset, the page keeps it.
        m_page->select(*shelf()[1].preset);
        m_page->setPresets(shelf(), shipped());
        QVERIFY2(shown().contains("version 1"), qPrintable(shown()));
    }

    void aCopyHasAnotherName()
    {
        QSignalSpy saved(m_page, &presets::PresetsPage::saveRequested);
        click("presetCopy");
        QCOMPARE(m_page->draft().name, std::string("natural copy"));
        QTest::keyClicks(child<QLineEdit>("presetName"), "mine");
        click("presetSave");
        QCOMPARE(saved[0][0].value<FeelPreset>().name, std::string("mine"));
        child<QLineEdit>("presetName")->selectAll();
        QTest::keyClick(child<QLineEdit>("presetName"), Qt::Key_Delete);
        QVERIFY(!isEnabled("presetSave"));
    }

    void comparesWithTheChosenOne()
    {
        QSignalSpy compared(m_page, &presets::PresetsPage::compareRequested);
        auto* other = child<QComboBox>("presetOther");
        QCOMPARE(other->count(), 3);  // a preset that cannot be read is not offered
        // A preset is not compared with itself. Another one is offered, or the unsaved draft.
        auto* compare = child<QPushButton>("presetCompare");
        QVERIFY(compare->isEnabled() && !other->currentText().startsWith("natural"));
        other->setCurrentText("natural v2");
        emit other->activated(other->currentIndex());
        QVERIFY(!compare->isEnabled());
        auto* slider = child<QSlider>("dial0");
        slider->setValue(slider->maximum());
        QVERIFY(compare->isEnabled());
        slider->setValue(0);
        other->setCurrentIndex(1);
        emit other->activated(1);
        click("presetCompare");
        QCOMPARE(compared[0][0].value<FeelPreset>().name, std::string("natural"));
        QVERIFY(compared[0][1].value<FeelPreset>() == presetNamed("hard", 1, 0.5));
        QCOMPARE(compared[0][2].toInt(), 8);
    }

    void trialCardTunesAndTellsApart()
    {
        presets::TrialCard& card = makeCard();
        QSignalSpy fresh(&card, &presets::TrialCard::freshBlockRequested);
        QSignalSpy csv(&card, &presets::TrialCard::csvRequested);
        card.tune(FeelPreset{}, FeelPreset{});
        cardDial().setValue(10);
        QCOMPARE(m_felt->size(), 1);
        QVERIFY(felt().enamelRate < 0.7);
        QVERIFY(card.tuned()->enamelRate < 0.7);
        click("trialReset");
        QVERIFY(*card.tuned() == FeelPreset{});
        // The feed chart follows the dial.
        cardDial().setValue(10);
        auto* feed = card.findChild<presets::FeedChart*>();
        QVERIFY(feed->isVisible() && feed->words(1.0).contains("Enamel 0.2 mm/s"));
        QVERIFY(card.findChild<QLabel*>("feedWords")->text().contains("dashed"));

        const FeelPreset first = presetNamed("hard", 1, 0.3);
        card.compare(BlindTrial(first, presetNamed("soft", 1, 0.9), 4, 3));
        QVERIFY(!card.tuned());
        for (int trial = 0; trial < 4; ++trial) {
            const FeelPreset a = felt();
            QVERIFY(presets::isVeiled(a));
            // The user can answer only after they have drilled with both.
            card.follow(1, 0, 0.0);
            card.follow(1, 0, 0.2);
            QVERIFY(!isEnabled("trialSaysA"));
            click("trialB");
            QVERIFY(felt().enamelRate != a.enamelRate);
            card.follow(1, 0, 0.2);
            QVERIFY(!isEnabled("trialSaysA"));
            card.follow(1, 0, 0.3);
            QVERIFY(isEnabled("trialSaysA"));
            // No text in the window reveals which preset is which.
            for (const QLabel* label : card.findChildren<QLabel*>())
                QVERIFY2(!label->isVisible() || !(label->text().contains("hard") || label->text().contains("soft ")),
                         qPrintable(label->text()));
            click(a.enamelRate == first.enamelRate ? "trialSaysA" : "trialSaysB");
        }
        QCOMPARE(fresh.size(), 3);
        QVERIFY(!presets::isVeiled(felt()));  // the trial is over
        const QString said = textOf("trialWords");
        QVERIFY2(said.contains("chosen 4 time") && said.contains("13 time(s) in 100"), qPrintable(said));
        click("trialCsv");
        QCOMPARE(csv.size(), 1);
    }

    void aComparisonCanBeEnded()
    {
        presets::TrialCard& card = makeCard();
        QSignalSpy done(&card, &presets::TrialCard::done);
        const auto* end = child<QPushButton>("trialEnd");
        const auto* back = child<QPushButton>("trialBack");
        card.tune(FeelPreset{}, FeelPreset{});
        QVERIFY(!end->isVisible() && back->isVisible());
        for (const int answers : {0, 1}) {
            card.compare(BlindTrial(presetNamed("hard", 1, 0.3), presetNamed("soft", 1, 0.9), 4, 3));
            // During a comparison only the button that ends it is visible.
            QVERIFY(card.isComparing() && end->isVisible() && !back->isVisible());
            for (int trial = 0; trial < answers; ++trial) {
                for (const char* letter : {"trialA", "trialB"}) {
                    click(letter);
                    card.follow(1, 0, 0.0);
                    card.follow(1, 0, 0.1);
                }
                click("trialSaysNone");
            }
            click("trialB");
            const FeelPreset held = felt();
            click("trialEnd");
            QVERIFY(!card.isComparing() && !end->isVisible() && back->isVisible());
            // The previous preset is felt again, and the result is shown.
            QVERIFY(!presets::isVeiled(felt()));
            QCOMPARE(felt().enamelRate, held.enamelRate);
            const QString said = textOf("trialWords");
            QVERIFY2(said.contains(answers == 0 ? "before anything was chosen" : "No difference: 1 time"),
                     qPrintable(said));
            QCOMPARE(child<QPushButton>("trialCsv")->isVisible(), answers > 0);
        }
        click("trialBack");
        QCOMPARE(done.size(), 1);
    }

    void allAsItWasUndoesTheConsoleToo()
    {
        presets::TrialCard& card = makeCard();
        const FeelPreset base = presetNamed("hard", 1, 0.3);
        card.tune(base, base);
        FeelPreset byHand = base;
        byHand.stiffnessNPerMm = 1.7654;  // no position of the dial gives this value
        byHand.hash.clear();
        card.tune(base, byHand);  // as the console does
        click("trialReset");
        QVERIFY(*card.tuned() == base);
        QVERIFY(felt() == base);
        // Resets to the preset that was typed on the page and is being tried.
        card.hide();
        card.tune(base, byHand);
        cardDial().setValue(10);
        click("trialReset");
        QVERIFY(*card.tuned() == byHand);
    }

    void changesAreDiscardedOnlyWhenTheUserSaysSo()
    {
        const auto answer = [&](const char* button) {
            QTRY_VERIFY(m_window->findChild<QWidget*>("unsavedQuestion") != nullptr);
            m_window->findChild<QWidget*>("unsavedQuestion")->findChild<QPushButton*>(button)->click();
        };
        child<QSlider>("dial0")->setValue(10);
        const FeelPreset changed = m_page->draft();
        QVERIFY(!m_page->unsavedChanges().isEmpty());
        list().setCurrentRow(0);
        answer("questionStay");
        QVERIFY(m_page->draft() == changed && list().currentRow() == 2);
        // A version that is saved or imported meanwhile does not replace the changed one. The changed one appears when
        // it is saved.
        m_page->select(presetNamed("hard", 1, 0.5));
        QVERIFY(m_page->draft() == changed);
        list().setCurrentRow(0);
        answer("questionDiscard");
        QVERIFY(m_page->draft() == presetNamed("hard", 2, 0.4) && list().currentRow() == 0);
        QVERIFY(m_page->unsavedChanges().isEmpty());
        child<QSlider>("dial1")->setValue(5);
        m_page->setMayKeep(false);
        QVERIFY(m_page->unsavedChanges().isEmpty());  // a user who cannot save is not asked
        m_page->discardChanges();
        QVERIFY(m_page->draft() == shipped() && list().currentRow() == 2);
    }

    void whatWasLoadedInATrialIsThatPreset()
    {
        FeelPreset loaded = presetNamed("hard", 2, 0.4);
        loaded.stiffnessNPerMm = 1.5;
        loaded.hash.clear();
        m_page->setDraft(loaded);
        QCOMPARE(child<QLineEdit>("presetName")->text(), QString("hard"));
        QVERIFY(textOf("presetVersion").contains("changed from hard, version 2"));
        QCOMPARE(list().currentRow(), 0);
    }

    void faultsAreToldInWords_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const QByteArray& json, const char* says) {
            QTest::newRow(name) << json << QString(says);
        };
        row("too stiff", R"({"force": {"stiffness_n_per_mm": 15}})", "Would tremble");
        row("out of range", R"({"enamel": {"rate_mm3_per_ns": -1}})",
            "x.cusppreset, enamel.rate_mm3_per_ns: is -1, it must lie between 0 and 100");
        row("no JSON", "{", "x.cusppreset is not JSON: line 1, column 2");
        row("another kind", R"({"kind": "cusp-lesson"})", "kind: says that this is no hardness preset");
        row("the future", R"({"format": 3})", "format: is 3, from a newer Cusp");
        row("no version", R"({"version": 1.5})", "version: is 1.5, it must be a whole number");
        row("a name of two lines", R"({"name": "a\nb"})", "name: must be one line");
        row("a number for an object", R"({"force": 2})", "force: is a number; write an object in braces");
        row("a slip of a key", R"({"enamell": {}})", "did you mean \"enamel\"?");
    }

    void faultsAreToldInWords()
    {
        QFETCH(QByteArray, json);
        QFETCH(QString, says);
        const lessons::ReadPreset read = lessons::readPresetText(json, "x.cusppreset");
        const QString said = ui::text::faultWords(read);
        QVERIFY2(said.contains(says) && !said.contains(u'\n'), qPrintable(said));
        QTranslator german;
        QVERIFY(german.load(":/i18n/cusp_de.qm"));
        QCoreApplication::installTranslator(&german);
        const QString inGerman = ui::text::faultWords(read);
        QVERIFY2(inGerman != said && !inGerman.contains(" is ") && !inGerman.contains("must"), qPrintable(inGerman));
    }

    void chartIsSavedAndWalkedWithKeys()
    {
        presets::FeedChart chart(nullptr);
        FeelPreset preset;
        preset.enamelRate = 2.0;
        chart.setPreset(preset, FeelPreset{});
        QVERIFY2(chart.words(1.0).contains("Enamel 1.4 mm/s"), qPrintable(chart.words(1.0)));
        QTest::keyClick(&chart, Qt::Key_Right);
        QCOMPARE(chart.accessibleDescription(), chart.words(1.1));
        QTest::keyClick(&chart, Qt::Key_End);
        QCOMPARE(chart.accessibleDescription(), chart.words(2.0));
        const QTemporaryDir folder;
        for (const char* name : {"feed.png", "feed.svg", "feed.csv"})
            QVERIFY2(chart.findChild<charts::SaveButton*>()->save(folder.filePath(name)), name);
        const auto table = QByteArray::fromStdString(support::bytesOf(folder.filePath("feed.csv").toStdString()));
        QVERIFY2(table.startsWith("series,\"Force, N\",\"Feed, mm/s\"\r\n"), table.constData());
        QVERIFY(table.contains("\r\nEnamel,0,0\r\n") && table.contains("\r\n\"Enamel, as it was kept\",2,"));
        QVERIFY(!table.contains("Dentine, as"));
    }

    void everyControlHasAName()
    {
        makeCard().tune(FeelPreset{}, FeelPreset{});
        QCOMPARE(support::controlsWithoutNames(*m_window), QStringList());
    }

    void whatIsRetiredIsOfferedToNobody()
    {
        auto* retire = child<QPushButton>("presetRetire");
        const auto* other = child<QComboBox>("presetOther");
        QVERIFY(!retire->isVisible());  // visible for an admin only
        auto all = shelf();
        all[0].isRetired = all[1].isRetired = true;
        m_page->setPresets(all, shipped());
        QCOMPARE(list().count(), 2);
        QVERIFY(other->findText("hard v1") < 0);
        m_page->setMayRetire(true);
        m_page->setPresets(all, shipped());
        QCOMPARE(list().count(), 4);
        QVERIFY(list().item(0)->text().contains("retired") && other->findText("hard v1") < 0);
        QVERIFY(retire->isVisible() && !retire->isEnabled());  // a shipped preset cannot be retired
        list().setCurrentRow(0);
        QVERIFY(!isEnabled("presetUse"));
        QSignalSpy wanted(m_page, &presets::PresetsPage::retireRequested);
        retire->click();
        m_page->setPresets(shelf(), shipped());
        retire->click();
        QCOMPARE(wanted.count(), 2);
        QCOMPARE(wanted[0], (QVariantList{"hard", false}));
        QCOMPARE(wanted[1], (QVariantList{"hard", true}));
        // A retired preset that is in use remains visible to everybody.
        m_page->setMayRetire(false);
        m_page->setPresets(all, presetNamed("hard", 1, 0.5));
        QCOMPARE(list().count(), 3);
    }

private:
    [[nodiscard]] bool isEnabled(const char* button) const { return child<QPushButton>(button)->isEnabled(); }
    [[nodiscard]] QListWidget& list() const { return *child<QListWidget>("presetList"); }
    [[nodiscard]] QDoubleSpinBox* spin(const char* number) const { return child<QDoubleSpinBox>(number); }
    /// Returns a card for a blind trial. It appears above the page as soon as it has something to show.
    presets::TrialCard& makeCard()
    {
        m_card = new presets::TrialCard(m_window.get());
        m_card->resize(412, 700);
        m_felt.emplace(m_card, &presets::TrialCard::felt);
        return *m_card;
    }
    [[nodiscard]] QSlider& cardDial() const { return *m_card->findChild<QSlider*>("dial0"); }
    /// The last preset that the card let the user feel.
    [[nodiscard]] FeelPreset felt() const { return m_felt->back()[0].value<FeelPreset>(); }

    presets::TrialCard* m_card = nullptr;
    std::optional<QSignalSpy> m_felt;
};

CUSP_TEST(TestPresetsPage)
#include "tst_presets_page.moc"
