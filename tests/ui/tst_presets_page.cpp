// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <QWidget>
#include <cmath>

#include "core/settings/StabilityBound.h"
#include "ui/charts/SaveButton.h"
#include "ui/presets/BlindTrial.h"
#include "ui/presets/FeedChart.h"
#include "ui/presets/PresetWords.h"
#include "ui/presets/PresetsPage.h"
#include "ui/presets/SimpleFeel.h"
#include "ui/presets/TrialCard.h"
#include "ui/shell/Actions.h"
#include "ui/shell/Theme.h"

using namespace ui;
using core::settings::FeelPreset;
using presets::BlindTrial;
using presets::Dial;
using presets::Dials;

Q_DECLARE_METATYPE(core::settings::FeelPreset)

namespace {

FeelPreset named(const char* name, int version, double enamelRate)
{
    FeelPreset preset;
    preset.name = name;
    preset.version = version;
    preset.enamelRate = enamelRate;
    return lessons::hashed(preset);
}

/// The page on a small shelf, shown.
struct Room
{
    QWidget window;
    shell::Actions actions{&window};
    presets::PresetsPage page{actions, &window};

    Room()
    {
        page.resize(1280, 760);
        window.resize(1280, 760);
        page.setPresets(shelf(), lessons::shippedPresets().front());
        window.show();
    }
    static std::vector<lessons::ReadPreset> shelf()
    {
        return {{"/a", named("hard", 2, 0.4), {}},
                {"/b", named("hard", 1, 0.5), {}},
                {{}, lessons::shippedPresets().front(), {}},
                {"/bad.cusppreset", {}, {{"/bad.cusppreset", {}, {"is empty"}, true}}}};
    }
    template <class T>
    T* find(const char* name)
    {
        T* found = page.findChild<T*>(name);
        if (found == nullptr)
            qFatal("no %s", name);
        return found;
    }
};

Dials dials(Dial which, double turn)
{
    Dials all{};
    all.at(static_cast<std::size_t>(which)) = turn;
    return all;
}

}  // namespace

class TestPresetsPage : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        qRegisterMetaType<FeelPreset>();
        shell::applyTheme(*qApp, shell::ThemeChoice::Light);
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

    void binomialIsExact_data()
    {
        QTest::addColumn<int>("hits");
        QTest::addColumn<int>("of");
        QTest::addColumn<double>("p");
        QTest::newRow("none") << 0 << 1 << 1.0;
        QTest::newRow("even") << 4 << 8 << 1.0;
        QTest::newRow("all of eight") << 8 << 8 << 2.0 / 256.0;
        QTest::newRow("none of eight") << 0 << 8 << 2.0 / 256.0;
        QTest::newRow("seven of eight") << 7 << 8 << 18.0 / 256.0;
        QTest::newRow("two of ten") << 2 << 10 << 112.0 / 1024.0;
    }

    void binomialIsExact()
    {
        QFETCH(int, hits);
        QFETCH(int, of);
        QFETCH(double, p);
        QVERIFY(std::abs(presets::binomialP(hits, of) - p) < 1.0e-9);
    }

    void blindTrialCountsWhatWasBehindTheLetters()
    {
        const FeelPreset first = named("a, \"b\"", 1, 0.5);
        const FeelPreset second = named("plain", 2, 0.7);
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
            trial.answer(BlindTrial::Answer::A);  // it is over
            const BlindTrial::Outcome outcome = trial.outcome();
            QVERIFY(outcome.first == 8 && outcome.second == 0 && outcome.neither == 2);
            QVERIFY(std::abs(outcome.p - 2.0 / 256.0) < 1.0e-9);
            const QList<QByteArray> lines = trial.csv().trimmed().split('\n');
            QCOMPARE(lines.size(), 11);
            QCOMPARE(lines.front(), QByteArray("trial,behind_a,behind_b,answer,chosen"));
            QVERIFY2(lines[1].contains("\"a, \"\"b\"\" v1 #"), lines[1]);
        }
        QVERIFY(asA > 150 && asA < 250);  // of 400
    }

    void listsEveryVersionAndWhatIsWrong()
    {
        Room room;
        auto* list = room.find<QListWidget>("presetList");
        auto* save = room.find<QPushButton>("presetSave");
        QCOMPARE(list->count(), 4);
        QVERIFY(list->item(0)->text().contains("version 2"));
        QVERIFY(list->item(2)->text().contains("shipped") && list->item(2)->text().contains("in use"));
        QVERIFY(!(list->item(3)->flags() & Qt::ItemIsSelectable) && list->item(3)->text().contains("is empty"));
        QCOMPARE(list->currentRow(), 2);  // what is in use
        QVERIFY(!room.find<QPushButton>("presetUse")->isEnabled());
        list->setCurrentRow(0);
        QVERIFY(!save->isEnabled());
        list->setCurrentRow(1);
        QVERIFY(room.page.draft() == named("hard", 1, 0.5));
        QVERIFY(save->isEnabled() && save->text().startsWith("Restore"));  // an older version
        QSignalSpy use(&room.page, &presets::PresetsPage::useWanted);
        QTest::mouseClick(room.find<QPushButton>("presetUse"), Qt::LeftButton);
        QCOMPARE(use.size(), 1);
    }

    void aChangedNumberCanBeTriedAndKept()
    {
        Room room;
        QSignalSpy tried(&room.page, &presets::PresetsPage::tryWanted);
        QSignalSpy saved(&room.page, &presets::PresetsPage::saveWanted);
        QVERIFY(!room.find<QPushButton>("presetSave")->isEnabled());
        QTest::mouseClick(room.find<QPushButton>("presetExpert"), Qt::LeftButton);
        room.find<QDoubleSpinBox>("enamel.rate_mm3_per_ns")->setValue(0.6);
        QCOMPARE(room.page.draft().enamelRate, 0.6);
        QVERIFY(room.find<QLabel>("presetVersion")->text().contains("changed from natural, version 1"));
        QTest::mouseClick(room.find<QPushButton>("presetTry"), Qt::LeftButton);
        QCOMPARE(tried.size(), 1);
        QCOMPARE(tried[0][0].value<FeelPreset>().enamelRate, 0.7);
        QCOMPARE(tried[0][1].value<FeelPreset>().enamelRate, 0.6);
        QVERIFY(!room.find<QPushButton>("presetExport")->isEnabled());  // only what has a version leaves the house
        QTest::mouseClick(room.find<QPushButton>("presetSave"), Qt::LeftButton);
        QCOMPARE(saved[0][0].value<FeelPreset>().version, 0);
        QCOMPARE(saved[0][0].value<FeelPreset>().name, std::string("natural"));
    }

    void whatIsNotHeldCanNeitherBeTriedNorKept()
    {
        Room room;
        QVERIFY(room.find<QLabel>("presetBound")->text().startsWith("Holds"));
        QTest::mouseClick(room.find<QPushButton>("presetExpert"), Qt::LeftButton);
        room.find<QDoubleSpinBox>("force.stiffness_n_per_mm")->setValue(8.0);
        const QString said = room.find<QLabel>("presetBound")->text();
        QVERIFY2(said.contains("5.37 N/mm") && said.contains("8.00"), qPrintable(said));
        QVERIFY(!room.find<QPushButton>("presetTry")->isEnabled());
        QVERIFY(!room.find<QPushButton>("presetSave")->isEnabled());
        room.find<QDoubleSpinBox>("force.stiffness_n_per_mm")->setValue(3.0);
        QVERIFY(room.find<QPushButton>("presetSave")->isEnabled());
        room.find<QDoubleSpinBox>("force.limit_n")->setValue(12.0);
        QVERIFY(room.find<QLabel>("presetBound")->text().contains("8.9 N"));
        QVERIFY(!room.find<QPushButton>("presetSave")->isEnabled());
    }

    void slidersAndNumbersAreOnePreset()
    {
        Room room;
        auto* slider = room.find<QSlider>("dial0");
        slider->setValue(slider->maximum());
        QCOMPARE(room.page.draft().enamelRate, 0.175);
        QTest::mouseClick(room.find<QPushButton>("presetExpert"), Qt::LeftButton);
        QCOMPARE(room.find<QDoubleSpinBox>("enamel.rate_mm3_per_ns")->value(), 0.175);
        room.find<QDoubleSpinBox>("dentin.rate_mm3_per_ns")->setValue(1.0);
        QTest::mouseClick(room.find<QPushButton>("presetSimple"), Qt::LeftButton);
        QCOMPARE(slider->value(), 0);  // from here on: no slider reaches these numbers
        slider->setValue(slider->minimum());
        // As often as the panels are changed, and after a trial, they stand where they were left.
        for (int round = 0; round < 3; ++round) {
            QTest::mouseClick(room.find<QPushButton>("presetExpert"), Qt::LeftButton);
            QTest::mouseClick(room.find<QPushButton>("presetSimple"), Qt::LeftButton);
            room.page.setDraft(FeelPreset(room.page.draft()));
        }
        QCOMPARE(room.page.draft().enamelRate, 0.7);
        QCOMPARE(room.page.draft().dentinRate, 1.0);
    }

    void slidersStandWhereTheVersionStands()
    {
        Room room;
        auto* wall = room.find<QSlider>("dial5");
        const auto* middle = room.find<QLabel>("dialMiddle");
        QCOMPARE(middle->text(), QString("In the middle: natural, version 1."));
        auto shelf = Room::shelf();
        const auto keep = [&](int version) {
            FeelPreset kept = room.page.draft();
            kept.version = version;
            kept = lessons::hashed(kept);
            shelf.push_back({"/c", kept, {}});
            room.page.setPresets(shelf, lessons::shippedPresets().front());
            room.page.select(kept);
        };
        wall->setValue(wall->minimum());
        keep(2);
        QVERIFY(room.find<QLabel>("presetVersion")->text().startsWith("version 2"));
        QCOMPARE(wall->value(), wall->minimum());  // no softer than it can be, however often it is kept
        QCOMPARE(middle->text(), QString("In the middle: natural, version 1."));
        wall->setValue(0);
        QCOMPARE(room.page.draft().stiffnessNPerMm, lessons::shippedPresets().front().stiffnessNPerMm);
        QVERIFY(room.find<QLabel>("presetVersion")->text().contains("changed from natural, version 2"));
        // Numbers that no slider comes to are the middle; kept, they have a version.
        QTest::mouseClick(room.find<QPushButton>("presetExpert"), Qt::LeftButton);
        room.find<QDoubleSpinBox>("dentin.rate_mm3_per_ns")->setValue(1.234);
        QTest::mouseClick(room.find<QPushButton>("presetSimple"), Qt::LeftButton);
        QVERIFY2(middle->text().contains("typed"), qPrintable(middle->text()));
        keep(3);
        QCOMPARE(middle->text(), QString("In the middle: natural, version 3."));
        wall->setValue(5);
        keep(4);
        QCOMPARE(middle->text(), QString("In the middle: natural, version 3."));
        QCOMPARE(wall->value(), 5);
    }

    void whatIsInUseIsShownUntilAnotherIsLookedAt()
    {
        Room room;  // shows the shipped one, in use
        const auto shown = [&] { return room.find<QListWidget>("presetList")->currentItem()->text(); };
        QVERIFY2(shown().contains("natural") && shown().contains("in use"), qPrintable(shown()));
        // Somebody logs in at whose school another is in use.
        room.page.setPresets(Room::shelf(), *Room::shelf()[0].preset);
        QVERIFY2(shown().contains("hard") && shown().contains("version 2"), qPrintable(shown()));
        QCOMPARE(room.find<QLineEdit>("presetName")->text(), QString("hard"));
        // He looks at another, and that stays.
        room.page.select(*Room::shelf()[1].preset);
        room.page.setPresets(Room::shelf(), lessons::shippedPresets().front());
        QVERIFY2(shown().contains("version 1"), qPrintable(shown()));
    }

    void aCopyHasAnotherName()
    {
        Room room;
        QSignalSpy saved(&room.page, &presets::PresetsPage::saveWanted);
        QTest::mouseClick(room.find<QPushButton>("presetCopy"), Qt::LeftButton);
        QCOMPARE(room.page.draft().name, std::string("natural copy"));
        QTest::keyClicks(room.find<QLineEdit>("presetName"), "mine");
        QTest::mouseClick(room.find<QPushButton>("presetSave"), Qt::LeftButton);
        QCOMPARE(saved[0][0].value<FeelPreset>().name, std::string("mine"));
        room.find<QLineEdit>("presetName")->selectAll();
        QTest::keyClick(room.find<QLineEdit>("presetName"), Qt::Key_Delete);
        QVERIFY(!room.find<QPushButton>("presetSave")->isEnabled());
    }

    void comparesWithTheChosenOne()
    {
        Room room;
        QSignalSpy compared(&room.page, &presets::PresetsPage::compareWanted);
        auto* other = room.find<QComboBox>("presetOther");
        QCOMPARE(other->count(), 3);  // what cannot be read is no choice
        // Nothing is compared with itself: another is offered, or what was changed.
        auto* compare = room.find<QPushButton>("presetCompare");
        QVERIFY(compare->isEnabled() && !other->currentText().startsWith("natural"));
        other->setCurrentText("natural v1");
        emit other->activated(other->currentIndex());
        QVERIFY(!compare->isEnabled());
        auto* slider = room.find<QSlider>("dial0");
        slider->setValue(slider->maximum());
        QVERIFY(compare->isEnabled());
        slider->setValue(0);
        other->setCurrentIndex(1);
        emit other->activated(1);
        QTest::mouseClick(room.find<QPushButton>("presetCompare"), Qt::LeftButton);
        QCOMPARE(compared[0][0].value<FeelPreset>().name, std::string("natural"));
        QVERIFY(compared[0][1].value<FeelPreset>() == named("hard", 1, 0.5));
        QCOMPARE(compared[0][2].toInt(), 8);
    }

    void trialCardTunesAndTellsApart()
    {
        QWidget window;
        presets::TrialCard card(&window);
        window.resize(600, 700);
        card.resize(412, 700);
        window.show();
        QSignalSpy felt(&card, &presets::TrialCard::felt);
        QSignalSpy fresh(&card, &presets::TrialCard::freshBlockWanted);
        QSignalSpy csv(&card, &presets::TrialCard::csvWanted);
        card.tune(FeelPreset{}, FeelPreset{});
        card.findChild<QSlider*>("dial0")->setValue(10);
        QCOMPARE(felt.size(), 1);
        QVERIFY(felt[0][0].value<FeelPreset>().enamelRate < 0.7);
        QVERIFY(card.tuned()->enamelRate < 0.7);
        QTest::mouseClick(card.findChild<QPushButton*>("trialReset"), Qt::LeftButton);
        QVERIFY(*card.tuned() == FeelPreset{});
        // The feed is drawn as it is turned.
        card.findChild<QSlider*>("dial0")->setValue(10);
        auto* feed = card.findChild<presets::FeedChart*>();
        QVERIFY(feed->isVisible() && feed->words(1.0).contains("Enamel 0.4 mm/s"));
        QVERIFY(card.findChild<QLabel*>("feedWords")->text().contains("dashed"));

        felt.clear();
        const FeelPreset first = named("hard", 1, 0.3);
        const FeelPreset second = named("soft", 1, 0.9);
        card.compare(BlindTrial(first, second, 4, 3));
        QVERIFY(!card.tuned());
        for (int trial = 0; trial < 4; ++trial) {
            const auto a = felt.back()[0].value<FeelPreset>();
            QVERIFY(presets::isVeiled(a));
            // Who has not cut with both has nothing to say.
            card.follow(1, 0, 0.0);
            card.follow(1, 0, 0.2);
            QVERIFY(!card.findChild<QPushButton*>("trialSaysA")->isEnabled());
            QTest::mouseClick(card.findChild<QPushButton*>("trialB"), Qt::LeftButton);
            QVERIFY(felt.back()[0].value<FeelPreset>().enamelRate != a.enamelRate);
            card.follow(1, 0, 0.2);
            QVERIFY(!card.findChild<QPushButton*>("trialSaysA")->isEnabled());
            card.follow(1, 0, 0.3);
            QVERIFY(card.findChild<QPushButton*>("trialSaysA")->isEnabled());
            // Nothing in the window tells which is which.
            for (const QLabel* label : card.findChildren<QLabel*>())
                QVERIFY2(!label->isVisible() || !(label->text().contains("hard") || label->text().contains("soft ")),
                         qPrintable(label->text()));
            QTest::mouseClick(
                card.findChild<QPushButton*>(a.enamelRate == first.enamelRate ? "trialSaysA" : "trialSaysB"),
                Qt::LeftButton);
        }
        QCOMPARE(fresh.size(), 3);
        QVERIFY(!presets::isVeiled(felt.back()[0].value<FeelPreset>()));  // it is over
        const QString said = card.findChild<QLabel*>("trialWords")->text();
        QVERIFY2(said.contains("chosen 4 time") && said.contains("13 time(s) in 100"), qPrintable(said));
        QTest::mouseClick(card.findChild<QPushButton*>("trialCsv"), Qt::LeftButton);
        QCOMPARE(csv.size(), 1);
    }

    void aComparisonCanBeEnded()
    {
        QWidget window;
        presets::TrialCard card(&window);
        window.resize(600, 700);
        card.resize(412, 700);
        window.show();
        QSignalSpy felt(&card, &presets::TrialCard::felt);
        QSignalSpy done(&card, &presets::TrialCard::done);
        auto* end = card.findChild<QPushButton*>("trialEnd");
        auto* back = card.findChild<QPushButton*>("trialBack");
        const auto* words = card.findChild<QLabel*>("trialWords");
        card.tune(FeelPreset{}, FeelPreset{});
        QVERIFY(!end->isVisible() && back->isVisible());
        const FeelPreset first = named("hard", 1, 0.3);
        const FeelPreset second = named("soft", 1, 0.9);
        for (const int answers : {0, 1}) {
            card.compare(BlindTrial(first, second, 4, 3));
            // Nobody leaves it by a button that says nothing of it.
            QVERIFY(card.isComparing() && end->isVisible() && !back->isVisible());
            for (int trial = 0; trial < answers; ++trial) {
                for (const char* letter : {"trialA", "trialB"}) {
                    QTest::mouseClick(card.findChild<QPushButton*>(letter), Qt::LeftButton);
                    card.follow(1, 0, 0.0);
                    card.follow(1, 0, 0.1);
                }
                QTest::mouseClick(card.findChild<QPushButton*>("trialSaysNone"), Qt::LeftButton);
            }
            QTest::mouseClick(card.findChild<QPushButton*>("trialB"), Qt::LeftButton);
            const auto held = felt.back()[0].value<FeelPreset>();
            QTest::mouseClick(end, Qt::LeftButton);
            QVERIFY(!card.isComparing() && !end->isVisible() && back->isVisible());
            // It feels as it did, and is told.
            QVERIFY(!presets::isVeiled(felt.back()[0].value<FeelPreset>()));
            QCOMPARE(felt.back()[0].value<FeelPreset>().enamelRate, held.enamelRate);
            QVERIFY2(words->text().contains(answers == 0 ? "before anything was chosen" : "No difference: 1 time"),
                     qPrintable(words->text()));
            QCOMPARE(card.findChild<QPushButton*>("trialCsv")->isVisible(), answers > 0);
        }
        QTest::mouseClick(back, Qt::LeftButton);
        QCOMPARE(done.size(), 1);
    }

    void allAsItWasUndoesTheConsoleToo()
    {
        QWidget window;
        presets::TrialCard card(&window);
        QSignalSpy felt(&card, &presets::TrialCard::felt);
        const FeelPreset base = named("hard", 1, 0.3);
        card.tune(base, base);
        FeelPreset byHand = base;
        byHand.stiffnessNPerMm = 1.7654;  // no dial comes there
        byHand.hash.clear();
        card.tune(base, byHand);  // as the console does it
        QTest::mouseClick(card.findChild<QPushButton*>("trialReset"), Qt::LeftButton);
        QVERIFY(*card.tuned() == base);
        QVERIFY(felt.back()[0].value<FeelPreset>() == base);
        // What was typed on the page and is tried is what was.
        card.hide();
        card.tune(base, byHand);
        card.findChild<QSlider*>("dial0")->setValue(10);
        QTest::mouseClick(card.findChild<QPushButton*>("trialReset"), Qt::LeftButton);
        QVERIFY(*card.tuned() == byHand);
    }

    void changesAreDiscardedOnlyWhenTheUserSaysSo()
    {
        Room room;
        auto* list = room.find<QListWidget>("presetList");
        const auto answer = [&](const char* button) {
            QTRY_VERIFY(room.window.findChild<QWidget*>("unsavedQuestion") != nullptr);
            room.window.findChild<QWidget*>("unsavedQuestion")->findChild<QPushButton*>(button)->click();
        };
        room.find<QSlider>("dial0")->setValue(10);
        const FeelPreset changed = room.page.draft();
        QVERIFY(!room.page.unsavedChanges().isEmpty());
        list->setCurrentRow(0);
        answer("questionStay");
        QVERIFY(room.page.draft() == changed && list->currentRow() == 2);
        // A version that is saved meanwhile, or imported, does not take its place; what was changed does when it is
        // saved.
        room.page.select(named("hard", 1, 0.5));
        QVERIFY(room.page.draft() == changed);
        list->setCurrentRow(0);
        answer("questionDiscard");
        QVERIFY(room.page.draft() == named("hard", 2, 0.4) && list->currentRow() == 0);
        QVERIFY(room.page.unsavedChanges().isEmpty());
        room.find<QSlider>("dial1")->setValue(5);
        room.page.setMayKeep(false);
        QVERIFY(room.page.unsavedChanges().isEmpty());  // a user who may not save it is not asked
        room.page.discardChanges();
        QVERIFY(room.page.draft() == lessons::shippedPresets().front() && list->currentRow() == 2);
    }

    void whatWasLoadedInATrialIsThatPreset()
    {
        Room room;
        FeelPreset loaded = named("hard", 2, 0.4);
        loaded.stiffnessNPerMm = 1.5;
        loaded.hash.clear();
        room.page.setDraft(loaded);
        QCOMPARE(room.find<QLineEdit>("presetName")->text(), QString("hard"));
        QVERIFY(room.find<QLabel>("presetVersion")->text().contains("changed from hard, version 2"));
        QCOMPARE(room.find<QListWidget>("presetList")->currentRow(), 0);
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
        row("the future", R"({"format": 2})", "format: is 2, from a newer Cusp");
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
        const QString said = presets::faultWords(read);
        QVERIFY2(said.contains(says) && !said.contains(u'\n'), qPrintable(said));
        QTranslator german;
        QVERIFY(german.load(":/i18n/cusp_de.qm"));
        QCoreApplication::installTranslator(&german);
        const QString inGerman = presets::faultWords(read);
        QVERIFY2(inGerman != said && !inGerman.contains(" is ") && !inGerman.contains("must"), qPrintable(inGerman));
    }

    void chartIsSavedAndWalkedWithKeys()
    {
        presets::FeedChart chart(nullptr);
        FeelPreset preset;
        preset.enamelRate = 2.0;
        chart.setPreset(preset, FeelPreset{});
        QVERIFY2(chart.words(1.0).contains("Enamel 2.2 mm/s"), qPrintable(chart.words(1.0)));
        QTest::keyClick(&chart, Qt::Key_Right);
        QCOMPARE(chart.accessibleDescription(), chart.words(1.1));
        QTest::keyClick(&chart, Qt::Key_End);
        QCOMPARE(chart.accessibleDescription(), chart.words(2.0));
        const QTemporaryDir folder;
        for (const char* name : {"feed.png", "feed.svg", "feed.csv"})
            QVERIFY2(chart.findChild<charts::SaveButton*>()->save(folder.filePath(name)), name);
        QFile table(folder.filePath("feed.csv"));
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QByteArray bytes = table.readAll();
        QVERIFY2(bytes.startsWith("series,\"Force, N\",\"Feed, mm/s\"\r\n"), bytes.constData());
        QVERIFY(bytes.contains("\r\nEnamel,0,0\r\n") && bytes.contains("\r\n\"Enamel, as it was kept\",2,"));
        QVERIFY(!bytes.contains("Dentine, as"));
    }

    void everyControlHasAName()
    {
        Room room;
        presets::TrialCard card(&room.window);
        for (QWidget* root : {static_cast<QWidget*>(&room.page), static_cast<QWidget*>(&card)})
            for (QWidget* widget : root->findChildren<QWidget*>())
                if ((widget->focusPolicy() & Qt::TabFocus) != 0 && !widget->objectName().startsWith("qt_"))
                    QVERIFY2(!widget->accessibleName().isEmpty(),
                             qPrintable(QString("%1 %2").arg(widget->metaObject()->className(), widget->objectName())));
    }

    void whatIsRetiredIsOfferedToNobody()
    {
        Room room;
        auto* retire = room.find<QPushButton>("presetRetire");
        auto* list = room.find<QListWidget>("presetList");
        const auto* other = room.find<QComboBox>("presetOther");
        QVERIFY(!retire->isVisible());  // nobody but an admin
        auto shelf = Room::shelf();
        shelf[0].isRetired = shelf[1].isRetired = true;
        room.page.setPresets(shelf, lessons::shippedPresets().front());
        QCOMPARE(list->count(), 2);
        QVERIFY(other->findText("hard v1") < 0);
        room.page.setMayRetire(true);
        room.page.setPresets(shelf, lessons::shippedPresets().front());
        QCOMPARE(list->count(), 4);
        QVERIFY(list->item(0)->text().contains("retired") && other->findText("hard v1") < 0);
        QVERIFY(retire->isVisible() && !retire->isEnabled());  // what is shipped stays
        list->setCurrentRow(0);
        QVERIFY(!room.find<QPushButton>("presetUse")->isEnabled());
        QSignalSpy wanted(&room.page, &presets::PresetsPage::retireWanted);
        QTest::mouseClick(retire, Qt::LeftButton);
        room.page.setPresets(Room::shelf(), lessons::shippedPresets().front());
        QTest::mouseClick(retire, Qt::LeftButton);
        QCOMPARE(wanted.count(), 2);
        QCOMPARE(wanted[0], (QVariantList{"hard", false}));
        QCOMPARE(wanted[1], (QVariantList{"hard", true}));
        // In use it stays to be seen by everybody.
        room.page.setMayRetire(false);
        room.page.setPresets(shelf, named("hard", 1, 0.5));
        QCOMPARE(list->count(), 3);
    }
};

QTEST_MAIN(TestPresetsPage)
#include "tst_presets_page.moc"
