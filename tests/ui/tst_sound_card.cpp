// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QComboBox>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include "tests/support/Suite.h"
#include "tests/ui/PageTest.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/HandList.h"
#include "ui/devices/SoundCard.h"

using namespace ui::sound;
using ui::devices::DevicesPage;
using ui::devices::HandList;
using ui::devices::Sign;
using ui::devices::SoundCard;

class TestSoundCard : public support::PageTest<DevicesPage>
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        openPage();
        m_page->setChosen("pointer");
        m_page->show();
        child<HandList>()->selectHand(ui::devices::kSound);
        card().setOutputs({{"speakers", "Speakers", true}, {"headphones", "Headphones", false}});
        card().setReport(reportOf(SoundStage::Ready));
    }
    void cleanup() { m_window.reset(); }

    void itIsNoHand()
    {
        QCOMPARE(m_page->shownHand(), QString(ui::devices::kSound));
        QVERIFY(card().isVisible());
        QVERIFY(card().soundSwitch().isVisible());
        QVERIFY(!child<QPushButton>("deviceNext")->isVisible());
        QSignalSpy wanted(m_page, &DevicesPage::handRequested);
        child<HandList>()->setFocus();
        QTest::keyClick(child<HandList>(), Qt::Key_Return);
        QCOMPARE(wanted.count(), 0);
        QVERIFY(card().soundSwitch().hasFocus());
        child<HandList>()->selectHand("pointer");
        QVERIFY(!card().isVisible());
        QVERIFY(!card().soundSwitch().isVisible());
    }

    void eachStateHasItsWords_data()
    {
        QTest::addColumn<SoundStage>("stage");
        QTest::addColumn<bool>("isFallback");
        QTest::addColumn<Sign>("sign");
        QTest::addColumn<QString>("state");
        QTest::newRow("off") << SoundStage::Off << false << Sign::Off << "Off.";
        QTest::newRow("ready") << SoundStage::Ready << false << Sign::Ready << "Plays on Speakers.";
        QTest::newRow("playing") << SoundStage::Playing << false << Sign::Ready << "Plays on Speakers.";
        QTest::newRow("none") << SoundStage::NoOutput << false << Sign::Missing
                              << "Silent: this computer has no audio output.";
        QTest::newRow("refused") << SoundStage::Refused << false << Sign::Attention
                                 << "Silent: Speakers does not play.";
        QTest::newRow("another") << SoundStage::Playing << true << Sign::Attention
                                 << "The chosen output is missing; Speakers plays instead.";
    }
    void eachStateHasItsWords()
    {
        QFETCH(const SoundStage, stage);
        QFETCH(const bool, isFallback);
        QFETCH(const Sign, sign);
        QFETCH(const QString, state);
        card().setReport(reportOf(stage, isFallback));
        QCOMPARE(textOf("deviceState"), state);
        QVERIFY(!textOf("deviceHelp").isEmpty());
        HandList::Row row;
        for (const HandList::Row& one : child<HandList>()->rows())
            if (one.id == QLatin1String(ui::devices::kSound))
                row = one;
        QVERIFY(row.sign == sign);
        QCOMPARE(row.state, state);
        QCOMPARE(child<QPushButton>("playSample")->isEnabled(),
                 stage == SoundStage::Ready || stage == SoundStage::Playing);
    }

    void theSwitchTurnsItOff()
    {
        QSignalSpy changed(&card(), &SoundCard::settingsChanged);
        card().soundSwitch().click();
        QCOMPARE(changed.count(), 1);
        QVERIFY(!changed.front().front().value<SoundSettings>().isOn);
        QVERIFY(!slider("soundVolume")->isEnabled());
        card().soundSwitch().click();
        QVERIFY(changed.back().front().value<SoundSettings>().isOn);
        QVERIFY(slider("soundVolume")->isEnabled());
    }

    void eachPartHasASlider()
    {
        QSignalSpy changed(&card(), &SoundCard::settingsChanged);
        slider("soundVolume")->setValue(10);
        const char* const parts[] = {"handpieceVolume", "cuttingVolume", "contactVolume", "sprayVolume",
                                     "suctionVolume"};
        int percent = 10;
        for (const char* part : parts)
            slider(part)->setValue(percent += 11);
        QCOMPARE(changed.count(), 6);
        const auto volumes = changed.back().front().value<SoundSettings>().volumes;
        QCOMPARE(volumes.master, 0.1F);
        for (std::size_t part = 0; part < volumes.parts.size(); ++part)
            QCOMPARE(volumes.parts.at(part), 0.21F + 0.11F * static_cast<float>(part));
    }

    void anOutputIsChosen()
    {
        QSignalSpy changed(&card(), &SoundCard::settingsChanged);
        auto* const list = child<QComboBox>("audioOutput");
        QCOMPARE(list->count(), 3);
        QCOMPARE(list->currentIndex(), 0);
        list->setCurrentIndex(2);
        emit list->activated(2);
        QCOMPARE(changed.back().front().value<SoundSettings>().output, QByteArray("headphones"));
        // The output is unplugged and stays selected.
        card().setOutputs({{"speakers", "Speakers", true}});
        QCOMPARE(list->count(), 3);
        QCOMPARE(list->currentText(), QString("The chosen output (missing)"));
        card().setOutputs({{"headphones", "Headphones", true}});
        QCOMPARE(list->currentText(), QString("Headphones"));
    }

    void theSampleIsAskedFor()
    {
        QSignalSpy requested(&card(), &SoundCard::sampleRequested);
        click("playSample");
        QCOMPARE(requested.count(), 1);
        SoundReport report = reportOf(SoundStage::Playing);
        report.isPlayingSample = true;
        card().setReport(report);
        QVERIFY(!child<QPushButton>("playSample")->isEnabled());
    }

    void everyControlHasAName() { QCOMPARE(support::controlsWithoutNames(*m_page), QStringList()); }

private:
    [[nodiscard]] SoundCard& card() const { return m_page->sound(); }
    [[nodiscard]] QSlider* slider(const char* name) const { return child<QSlider>(name); }
    static SoundReport reportOf(SoundStage stage, bool isFallback = false)
    {
        SoundReport report;
        report.stage = stage;
        report.output = stage == SoundStage::NoOutput ? QString() : QStringLiteral("Speakers");
        report.isFallback = isFallback;
        return report;
    }
};

CUSP_TEST(TestSoundCard)
#include "tst_sound_card.moc"
