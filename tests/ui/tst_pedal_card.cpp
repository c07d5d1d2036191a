// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QVBoxLayout>
#include <limits>

#include "tests/support/Suite.h"
#include "tests/ui/PageTest.h"
#include "ui/devices/AxisBars.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/HandList.h"
#include "ui/devices/PedalCard.h"
#include "ui/tooth/PadInput.h"
#include "ui/window/PadKeys.h"

using namespace core::session;
using ui::devices::ControllerAction;
using ui::devices::ControllerSettings;
using ui::devices::DevicesPage;
using ui::devices::HandList;
using ui::devices::PedalCard;
using ui::devices::Sign;
using ui::window::PadArrow;

namespace {

Controller pedal(int instance = 1, const std::string& guid = "0300pedal")
{
    Controller made;
    made.guid = guid;
    made.name = "USB pedal";
    made.instance = instance;
    made.axes = {0.0F, -1.0F};
    made.presses = {0, 0, 0};
    return made;
}

Controller gamepad(int instance = 2)
{
    Controller made;
    made.guid = "0300pad";
    made.name = "Some pad";
    made.instance = instance;
    made.isGamepad = true;
    made.axes.resize(kGamepadAxes);
    made.presses.resize(kGamepadButtons);
    return made;
}

ControllerReport with(std::vector<Controller> controllers, PedalStage stage = PedalStage::NotChosen)
{
    ControllerReport report;
    report.controllers = std::move(controllers);
    report.pedal = stage;
    return report;
}

}  // namespace

class TestPedalCard : public support::PageTest<DevicesPage>
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        openPage();
        m_page->setChosen("pointer");
        m_page->show();
        child<HandList>()->selectHand(ui::devices::kPedals);
        for (QAction* action : {m_actions->drill, m_actions->pauseReplay, m_actions->slower, m_actions->faster})
            action->setEnabled(false);
    }
    void cleanup() { m_window.reset(); }

    void itIsNoHand()
    {
        QCOMPARE(m_page->shownHand(), QString(ui::devices::kPedals));
        QVERIFY(card().isVisible());
        QVERIFY(!child<QPushButton>("deviceNext")->isVisible());
        QVERIFY(!child<QWidget>("pedalLive")->isVisible());
        QVERIFY(row().sign == Sign::Off);
        child<HandList>()->selectHand("pointer");
        QVERIFY(!card().isVisible());
    }

    void aPedalThatIsGoneIsForgotten()
    {
        QSignalSpy chosen(&card(), &ui::devices::PedalCard::pedalChosen);
        QVERIFY(child<QPushButton>("forgetPedal")->isHidden());
        card().setPedal("guid", "Foot pedal");
        card().setReport(with({}, PedalStage::Missing));
        QVERIFY(child<QPushButton>("forgetPedal")->isVisible());
        child<QPushButton>("forgetPedal")->click();
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen.front().front().toString(), QString());
        QVERIFY(child<QPushButton>("forgetPedal")->isHidden());
        QVERIFY(row().sign == Sign::Off);
    }

    void eachStateHasItsSignAndWords()
    {
        QStringList states;
        QStringList helps;
        const auto check = [&](const ControllerReport& report, Sign sign) {
            card().setReport(report);
            QVERIFY(row().sign == sign);
            QCOMPARE(row().state, textOf("deviceState"));
            QVERIFY(!textOf("deviceHelp").isEmpty());
            QCOMPARE(support::controlsWithoutNames(*m_window), QStringList());
            states << textOf("deviceState");
            helps << textOf("deviceHelp");
        };
        check(with({}), Sign::Off);
        check(with({pedal(), gamepad()}, PedalStage::Ready), Sign::Ready);
        check(with({pedal()}, PedalStage::WaitsForRest), Sign::Attention);
        check(with({}, PedalStage::Missing), Sign::Attention);
        ControllerReport broken = with({});
        broken.error = {core::ErrorCode::FileUnreadable,
                        "No.",
                        {"This program was built without SDL 2: pedals and gamepads are left out."}};
        check(broken, Sign::Missing);
        QCOMPARE(states.removeDuplicates(), 0);
        QCOMPARE(helps.removeDuplicates(), 0);
        card().setReport(with({pedal(), gamepad()}));
        QVERIFY(textOf("deviceState").contains("USB pedal, Some pad"));
        card().setInBuild(false);
        QVERIFY(row().sign == Sign::Missing);
    }

    void aPedalIsTaughtByAPress()
    {
        card().setReport(with({pedal()}));
        QVERIFY(!child<QCheckBox>("runsBur")->isEnabled());
        QVERIFY(!child<QSpinBox>("pedalDeadZone")->isEnabled());
        QSignalSpy changed(&card(), &PedalCard::settingsChanged);
        QSignalSpy chosen(&card(), &PedalCard::pedalChosen);
        const QString before = textOf("pedalWords");
        click("teachPedal");
        QVERIFY(card().isLearning());
        QVERIFY(textOf("pedalWords") != before);
        Controller moving = pedal();
        const auto hold = [&](float reading, const auto& isDone) {
            moving.axes[1] = reading;
            QTRY_VERIFY((card().setReport(with({moving})), isDone()));
        };
        int times = 0;
        hold(-1.0F, [&] { return ++times > 3; });
        times = 0;
        hold(0.9F, [&] { return ++times > 3; });
        hold(-1.0F, [&] { return !card().isLearning(); });
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.front().front().toString(), QString("0300pedal"));
        const auto settings = changed.back().back().value<ControllerSettings>();
        QCOMPARE(settings.axis, 1);
        QVERIFY(qAbs(settings.shape.fullReading - 0.9) < 1e-6);
        QCOMPARE(settings.shape.restReading, -1.0);
        QVERIFY(child<QCheckBox>("runsBur")->isChecked());
        QVERIFY(child<QSpinBox>("pedalDeadZone")->isEnabled());
    }

    void inputsChangeTheShape()
    {
        ControllerSettings settings;
        settings.axis = 1;
        card().setSettings("0300pedal", settings);
        card().setReport(with({pedal()}));
        QSignalSpy changed(&card(), &PedalCard::settingsChanged);
        child<QCheckBox>("pedalInverted")->click();
        child<QSpinBox>("pedalDeadZone")->setValue(20);
        child<QDoubleSpinBox>("pedalCurve")->setValue(2.0);
        const auto set = changed.back().back().value<ControllerSettings>();
        QVERIFY(set.shape.isInverted);
        QCOMPARE(set.shape.deadZone, 0.2);
        QCOMPARE(set.shape.curve, 2.0);
        QCOMPARE(set.axis, 1);
        // A report in between does not change the settings.
        card().setReport(with({pedal()}));
        QCOMPARE(child<QSpinBox>("pedalDeadZone")->value(), 20);
    }

    void aButtonIsTaughtByAPress()
    {
        card().setReport(with({pedal()}));
        QSignalSpy changed(&card(), &PedalCard::settingsChanged);
        auto* const undo = child<QPushButton>("action1");
        const QString none = undo->text();
        undo->click();
        QVERIFY(card().isLearning());
        QVERIFY(textOf("buttonWords").contains("Undo"));
        Controller pressed = pedal();
        pressed.held = 1U << 2U;
        pressed.presses[2] = 1;
        card().setReport(with({pressed}));
        QVERIFY(!card().isLearning());
        QCOMPARE(undo->text(), QString("3"));
        QCOMPARE(changed.back().back().value<ControllerSettings>().buttonOf(ControllerAction::Undo), 2);
        QVERIFY(child<QWidget>("axisBars")->accessibleName().contains("3"));
        // If the same button is assigned to another action, it loses the first one.
        child<QPushButton>("action3")->click();
        ++pressed.presses[2];
        card().setReport(with({pressed}));
        QCOMPARE(undo->text(), none);
        QCOMPARE(changed.back().back().value<ControllerSettings>().buttonOf(ControllerAction::Mirror), 2);
        child<QPushButton>("action3")->click();
        child<QPushButton>("action3")->click();
        QCOMPARE(changed.back().back().value<ControllerSettings>().buttonOf(ControllerAction::Mirror),
                 ui::devices::kNoButton);
    }

    void aGamepadIsUsableAsItComes()
    {
        card().setReport(with({gamepad()}));
        QVERIFY(child<QWidget>("gamepadLayout")->isVisible());
        QCOMPARE(child<QPushButton>("action1")->text(), QString("B"));
        QVERIFY(child<QCheckBox>("runsBur")->isEnabled());
        QVERIFY(!child<QCheckBox>("runsBur")->isChecked());
        card().setReport(with({pedal()}));
        QVERIFY(!child<QWidget>("gamepadLayout")->isVisible());
    }

    void ofSeveralControllersOneIsShown()
    {
        card().setReport(with({pedal(), gamepad()}));
        auto* const choice = child<QComboBox>("controller");
        QCOMPARE(choice->count(), 2);
        QCOMPARE(card().shown()->instance, 1);
        choice->setCurrentIndex(1);
        emit choice->activated(1);
        QCOMPARE(card().shown()->instance, 2);
        card().setReport(with({pedal(), gamepad()}));
        QCOMPARE(card().shown()->instance, 2);
        card().setReport(with({pedal()}));  // unplugged
        QCOMPARE(card().shown()->instance, 1);
        card().setReport(with({}));
        QVERIFY(card().shown() == nullptr);
        QVERIFY(!child<QWidget>("pedalLive")->isVisible());
    }

    void sticksAndTriggersBecomeWishes()
    {
        Controller pad = gamepad();
        QVERIFY(ui::tooth::padInput(pad) == ui::tooth::PadInput{});
        pad.axes = {0.1F, -0.15F, 0.05F, 0.0F, 1.0F, 0.08F};  // drifts
        QVERIFY(ui::tooth::padInput(pad) == ui::tooth::PadInput{});
        pad.axes = {1.0F, 0.0F, 0.0F, -1.0F, 0.0F, 1.0F};
        ui::tooth::PadInput input = ui::tooth::padInput(pad);
        QCOMPARE(input.move.x, 1.0);
        QCOMPARE(input.turn.y, 1.0);
        QCOMPARE(input.press, 1.0);
        pad.axes = {0.6F, 0.0F, 0.0F, 0.0F, 0.0F, 0.55F};
        input = ui::tooth::padInput(pad);
        QVERIFY(input.move.x > 0.2 && input.move.x < 0.3);
        QVERIFY(qAbs(input.press - 0.5) < 1e-6);
        constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
        pad.axes = {kNan, kNan, kNan, kNan, kNan, kNan};
        QVERIFY(ui::tooth::padInput(pad) == ui::tooth::PadInput{});
        QVERIFY(ui::tooth::padInput(pedal()) == ui::tooth::PadInput{});
    }

    void theArrowsOfAGamepadGoThroughTheControls()
    {
        QWidget window;
        auto* column = new QVBoxLayout(&window);
        auto* first = new QPushButton("first", &window);
        auto* slider = new QSlider(Qt::Horizontal, &window);
        auto* number = new QSpinBox(&window);
        auto* choice = new QComboBox(&window);
        choice->addItems({"one", "two"});
        auto* list = new QListWidget(&window);
        list->addItems({"a", "b"});
        auto* last = new QPushButton("last", &window);
        for (QWidget* one : {static_cast<QWidget*>(first), static_cast<QWidget*>(slider), static_cast<QWidget*>(number),
                             static_cast<QWidget*>(choice), static_cast<QWidget*>(list), static_cast<QWidget*>(last)})
            column->addWidget(one);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        first->setFocus();
        QSignalSpy clicked(first, &QPushButton::clicked);
        ui::window::chooseByPad();
        QCOMPARE(clicked.count(), 1);
        const auto step = [&](PadArrow arrow) { ui::window::stepByPad(window, arrow); };
        step(PadArrow::Down);
        QVERIFY(slider->hasFocus());
        step(PadArrow::Right);
        QVERIFY(slider->value() > 0);
        step(PadArrow::Down);
        QVERIFY(number->hasFocus());
        step(PadArrow::Right);
        QCOMPARE(number->value(), 1);
        step(PadArrow::Left);
        QCOMPARE(number->value(), 0);
        step(PadArrow::Down);
        QVERIFY(choice->hasFocus());
        step(PadArrow::Right);
        QCOMPARE(choice->currentIndex(), 1);
        step(PadArrow::Down);
        QVERIFY(list->hasFocus());
        list->setCurrentRow(0);
        step(PadArrow::Down);
        QCOMPARE(list->currentRow(), 1);
        step(PadArrow::Down);  // beyond the last entry
        QVERIFY(last->hasFocus());
        step(PadArrow::Up);
        QVERIFY(list->hasFocus());
    }

private:
    [[nodiscard]] PedalCard& card() const { return m_page->pedals(); }
    [[nodiscard]] HandList::Row row() const
    {
        for (const HandList::Row& one : child<HandList>()->rows())
            if (one.id == QLatin1String(ui::devices::kPedals))
                return one;
        return {};
    }
};

CUSP_TEST(TestPedalCard)
#include "tst_pedal_card.moc"
