// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <QCursor>
#include <QDoubleSpinBox>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include "core/session/RestHeight.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/ui/PageTest.h"
#include "tests/ui/Pictures.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/HandGuide.h"
#include "ui/devices/HandGuidePicture.h"
#include "ui/devices/HandList.h"
#include "ui/devices/StillnessTest.h"

using core::session::DeviceReport;
using core::session::DeviceSetup;
using core::session::DeviceStage;
using ui::devices::DevicesPage;
using ui::devices::HandGuide;
using ui::devices::HandList;
using ui::devices::StillnessTest;

namespace {

const QString kGuideArm = QStringLiteral("arm");
constexpr int kStepsOfGuide = 5;

DeviceReport gripAt(float heightMm)
{
    DeviceReport report;
    report.stage = DeviceStage::Ready;
    report.tipMm = {1.0F, 2.0F, heightMm};
    return report;
}

}  // namespace

class TestHandGuide : public support::PageTest<DevicesPage>
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init() { openForArm(); }
    void cleanup() { m_window.reset(); }

    void theKeyboardLeadsThroughAllSteps()
    {
        QStringList titles;
        click("openHandGuide");
        QVERIFY(guide().isVisible());
        QVERIFY(!child<HandList>()->isVisible());
        QVERIFY(child<QPushButton>("guideNext")->hasFocus());
        for (int step = 0; step < kStepsOfGuide; ++step) {
            titles << textOf("guideTitle");
            QVERIFY(!textOf("guideHelp").isEmpty());
            QCOMPARE(support::controlsWithoutNames(*m_window), QStringList());
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        }
        QCOMPARE(titles.removeDuplicates(), 0);
        QVERIFY(!guide().isVisible());
        QVERIFY(child<QPushButton>("openHandGuide")->hasFocus());
        click("openHandGuide");
        QCOMPARE(textOf("guideTitle"), titles.front());
        click("guideNext");
        click("guideBack");
        QCOMPARE(textOf("guideTitle"), titles.front());
        click("guideBack");
        QVERIFY(!guide().isVisible());
    }

    void theSpaceBarStartsTheTest()
    {
        child<HandList>()->selectHand("pointer");
        goTo(3);
        QVERIFY(child<QPushButton>("stillStart")->hasFocus());
        click("guideNext");
        QVERIFY(child<QPushButton>("guideNext")->hasFocus());
    }

    void oneStepBackLeadsToTheDevices()
    {
        goTo(2);
        QVERIFY(m_page->stepBack());
        QVERIFY(!guide().isVisible() && child<HandList>()->isVisible());
        QVERIFY(!m_page->stepBack());
    }

    void aPageThatOpensAgainShowsTheDevices()
    {
        click("openHandGuide");
        m_page->hide();
        m_page->show();
        QVERIFY(!guide().isVisible());
        QVERIFY(child<HandList>()->isVisible());
    }

    void theHandIsThatOfTheView()
    {
        click("openHandGuide");
        QVERIFY(child<QRadioButton>("rightHand")->isChecked());
        // Outside the practice room the action is disabled.
        m_actions->otherHand->setEnabled(false);
        child<QRadioButton>("leftHand")->click();
        QVERIFY(m_actions->otherHand->isChecked());
        m_actions->otherHand->setChecked(false);
        QVERIFY(child<QRadioButton>("rightHand")->isChecked());
    }

    void theHeightOfTheGripBecomesThatOfTheTooth()
    {
        m_page->setSetup(kGuideArm, {DeviceSetup::Stand::OnItsBack, DeviceSetup::Side::Left, 2.0});
        goTo(2);
        QSignalSpy changed(m_page, &DevicesPage::setupChanged);
        m_page->setReport(kGuideArm, gripAt(6.0F));
        QVERIFY2(textOf("gripHeight").contains("12 mm above"), qPrintable(textOf("gripHeight")));
        click("storeHeight");
        QCOMPARE(changed.count(), 1);
        QCOMPARE(changed.front().front().toString(), kGuideArm);
        const auto setup = changed.front().back().value<DeviceSetup>();
        QVERIFY(setup == (DeviceSetup{DeviceSetup::Stand::OnItsBack, DeviceSetup::Side::Left, 2.0, 12.0}));
        QVERIFY(textOf("restHeight").contains("12 mm above"));
        // From now on the device reports a bur at the top of the tooth at this height.
        m_page->setReport(kGuideArm, gripAt(-10.0F));
        QVERIFY2(textOf("gripHeight").contains("8 mm below"), qPrintable(textOf("gripHeight")));
        click("middleHeight");
        QCOMPARE(changed.back().back().value<DeviceSetup>().restMm, 0.0);
    }

    void aHeightThatHidesTheToothIsReducedAndSaid()
    {
        goTo(2);
        QSignalSpy changed(m_page, &DevicesPage::setupChanged);
        m_page->setReport(kGuideArm, gripAt(43.0F));
        const QString before = textOf("restHeight");
        click("storeHeight");
        const double stored = changed.back().back().value<DeviceSetup>().restMm;
        QCOMPARE(stored, core::session::reachableRestMm(43.0, 1.0));
        QVERIFY(stored < 43.0);
        QVERIFY2(textOf("restHeight").contains("43 mm"), qPrintable(textOf("restHeight")));
        click("middleHeight");
        QCOMPARE(textOf("restHeight"), before);
    }

    void aDeviceThatIsNotReadyIsWaitedFor()
    {
        DeviceReport lost;
        lost.stage = DeviceStage::Silent;
        goTo(2);
        m_page->setReport(kGuideArm, lost);
        QVERIFY(!child<QPushButton>("storeHeight")->isEnabled());
        QVERIFY(textOf("gripHeight").contains("not ready"));
        click("guideNext");
        QVERIFY(!child<QPushButton>("stillStart")->isEnabled());
        QVERIFY(!textOf("stillWords").isEmpty());
        m_page->setReport(kGuideArm, gripAt(0.0F));
        QVERIFY(child<QPushButton>("stillStart")->isEnabled());
        click("stillStart");
        m_page->setReport(kGuideArm, lost);
        QTRY_VERIFY(textOf("stillWords").contains("stopped"));
    }

    void driftAndTremorOfAHandAreMeasured_data()
    {
        QTest::addColumn<float>("driftMm");
        QTest::addColumn<float>("tremorMm");
        QTest::addColumn<QString>("words");
        QTest::newRow("steady") << 0.1F << 0.05F << "steady";
        QTest::newRow("drifts") << 1.5F << 0.05F << "drifts";
        QTest::newRow("trembles") << 0.1F << 0.4F << "trembles:";
    }
    void driftAndTremorOfAHandAreMeasured()
    {
        QFETCH(const float, driftMm);
        QFETCH(const float, tremorMm);
        QFETCH(const QString, words);
        goTo(3);
        m_page->setReport(kGuideArm, gripAt(0.0F));
        float times = 0.0F;
        runTest([&] {
            times += 1.0F;
            const float way = driftMm * times / 180.0F;
            const bool isOdd = std::fmod(times, 2.0F) > 0.5F;
            m_page->setReport(kGuideArm, gripAt(way + (isOdd ? tremorMm : -tremorMm)));
        });
        QVERIFY2(textOf("stillWords").contains(words), qPrintable(textOf("stillWords")));
        QVERIFY(textOf("stillWords").contains("On the tooth"));
        const QString result = textOf("stillWords");
        click("guideNext");
        QVERIFY(textOf("guideHelp").contains(result));
        QVERIFY(textOf("guideHelp").contains("Test Arm"));
        // Opened again, the guide starts without it.
        click("guideNext");
        click("openHandGuide");
        for (int step = 1; step < kStepsOfGuide; ++step)
            click("guideNext");
        QVERIFY(!textOf("guideHelp").contains(result));
    }

    void aPointerIsMeasuredOnTheScreen()
    {
        child<HandList>()->selectHand("pointer");
        goTo(2);
        QVERIFY(!child<QPushButton>("storeHeight")->isVisible());
        click("guideNext");
        const QPoint place = m_page->mapToGlobal(QPoint(300, 300));
        QCursor::setPos(place);
        runTest([] {});
        QVERIFY2(textOf("stillWords").contains("0.00 mm and trembled by 0.00 mm"), qPrintable(textOf("stillWords")));
        QVERIFY(textOf("stillWords").contains("screen"));
        int times = 0;
        runTest([&] { QCursor::setPos(place + QPoint(2 * ++times, 0)); });
        QVERIFY2(textOf("stillWords").contains("drifts"), qPrintable(textOf("stillWords")));
        click("guideNext");
        QVERIFY(!child<QDoubleSpinBox>("guideScale")->isVisible());
    }

    void theTestIsCancelled()
    {
        child<HandList>()->selectHand("pointer");
        goTo(3);
        const QString start = child<QPushButton>("stillStart")->text();
        click("stillStart");
        QVERIFY(child<QPushButton>("stillStart")->text() != start);
        click("stillStart");
        QCOMPARE(child<QPushButton>("stillStart")->text(), start);
        click("stillStart");
        click("guideNext");
        click("guideBack");
        QCOMPARE(child<QPushButton>("stillStart")->text(), start);
    }

    void theScaleIsChangedAtTheEnd()
    {
        m_page->setSetup(kGuideArm, {{}, {}, 1.0, 30.0});
        goTo(4);
        QSignalSpy changed(m_page, &DevicesPage::setupChanged);
        QCOMPARE(child<QDoubleSpinBox>("guideScale")->value(), 1.0);
        child<QDoubleSpinBox>("guideScale")->setValue(2.5);
        const auto setup = changed.back().back().value<DeviceSetup>();
        QCOMPARE(setup.scale, 2.5);
        QCOMPARE(setup.restMm, core::session::reachableRestMm(30.0, 2.5));
        QCOMPARE(child<QDoubleSpinBox>("scale")->value(), 2.5);  // the devices page shows the change
    }

    void everyStateCanBeDrawn_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::addColumn<QSize>("size");
        for (const bool isDark : {false, true})
            for (const QSize size : {QSize(1280, 800), QSize(1920, 1080), QSize(853, 520)})
                QTest::addRow("%s, %d", isDark ? "dark" : "light", size.width()) << isDark << size;
    }
    void everyStateCanBeDrawn()
    {
        QFETCH(bool, isDark);
        QFETCH(QSize, size);
        const auto reset = qScopeGuard([] { ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Light); });
        ui::kit::applyTheme(*qApp, isDark ? ui::kit::ThemeChoice::Dark : ui::kit::ThemeChoice::Light);
        openForArm();
        m_window->resize(size);
        m_page->resize(size);
        const auto draw = [&](const QString& name) {
            for (int n = 0; n < 3; ++n)  // a layout may trigger another one
                QCoreApplication::processEvents();
            const QImage image = m_window->grab().toImage();
            pictures::keep(
                image,
                QStringLiteral("guide-%1-%2-%3").arg(name, isDark ? "dark" : "light", QString::number(size.width())));
            const auto* const card = child<QWidget>("handGuideCard");
            QVERIFY2(card->width() >= card->minimumSizeHint().width() &&
                         card->height() >= card->minimumSizeHint().height() &&
                         card->parentWidget()->width() >= card->width(),
                     qPrintable(name));
            QVERIFY(child<ui::devices::HandGuidePicture>()->isVisible());
        };
        const std::array<QString, kStepsOfGuide> steps{"hand", "screen", "rest", "still", "summary"};
        for (const bool isArm : {true, false}) {
            child<HandList>()->selectHand(isArm ? kGuideArm : QStringLiteral("pointer"));
            click("openHandGuide");
            for (const QString& step : steps) {
                if (isArm && step == "rest") {
                    m_page->setReport(kGuideArm, gripAt(43.0F));
                    draw("rest-before");
                    click("storeHeight");
                    m_page->setReport(kGuideArm, gripAt(-9.0F));
                }
                draw((isArm ? "arm-" : "pointer-") + step);
                if (step == "still") {
                    click("stillStart");
                    draw((isArm ? "arm-" : "pointer-") + QStringLiteral("ready"));
                    click("stillStart");
                    runTest([] {});
                    draw((isArm ? "arm-" : "pointer-") + QStringLiteral("result"));
                }
                click("guideNext");
            }
            m_actions->otherHand->setChecked(true);
        }
    }

private:
    [[nodiscard]] HandGuide& guide() const { return *child<HandGuide>(); }
    void openForArm()
    {
        openPage();
        ui::devices::DeviceKind kind;
        kind.id = kGuideArm;
        kind.name = QStringLiteral("Test Arm");
        m_page->setKinds({kind});
        m_page->setChosen(kGuideArm);
        m_page->show();
        for (QAction* action : {m_actions->drill, m_actions->pauseReplay, m_actions->slower, m_actions->faster})
            action->setEnabled(false);
    }
    void goTo(int step) const
    {
        click("openHandGuide");
        for (int k = 0; k < step; ++k)
            click("guideNext");
    }
    /// Runs the stillness test to its end on a simulated clock.
    /// @param move  called before each reading
    template <class Move>
    void runTest(const Move& move) const
    {
        auto* const test = child<StillnessTest>();
        double seconds = 0.0;
        test->setClock([&] {
            move();
            return seconds += 1.0 / 30.0;
        });
        test->findChild<QTimer*>()->setInterval(0);
        click("stillStart");
        QTRY_COMPARE_WITH_TIMEOUT(child<QPushButton>("stillStart")->text(), QString("Once more"), 60000);
        test->setClock([] { return 0.0; });
    }
};

CUSP_TEST(TestHandGuide)
#include "tst_hand_guide.moc"
