// SPDX-License-Identifier: GPL-3.0-or-later
// Pedals and gamepads simulated by SDL's virtual joysticks, read by the code that reads real ones.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "haptics/pedal/ControllerInput.h"
#include "tests/support/VirtualController.h"
#include <QTest>

using namespace core::session;
using haptics::ControllerInput;
using haptics::FootPedal;
using support::VirtualController;

namespace {

std::unique_ptr<VirtualController> pedalNamed(const char* name)
{
    auto pedal = std::make_unique<VirtualController>(name, SDL_JOYSTICK_TYPE_THROTTLE, 3, 2);
    pedal->setAxis(0, -1.0);
    return pedal;
}

const Controller* find(const ControllerReport& report, int instance)
{
    const auto found = std::find_if(report.controllers.begin(), report.controllers.end(),
                                    [instance](const Controller& one) { return one.instance == instance; });
    return found == report.controllers.end() ? nullptr : &*found;
}

/// Returns the controller with this number; an empty one if none is plugged in.
Controller seen(const ControllerInput& input, int instance)
{
    const ControllerReport report = input.report();
    const Controller* const found = find(report, instance);
    return found == nullptr ? Controller{} : *found;
}

PedalSource axisOf(const Controller& pedal)
{
    return {pedal.guid, 0, -1, {}};
}

class BrokenPort final : public haptics::ControllerPort
{
public:
    explicit BrokenPort(float reading) : m_reading(reading) {}
    void read(std::vector<Controller>& controllers) override
    {
        Controller one;
        one.guid = "one";
        one.instance = 1;
        one.axes = {m_reading};
        controllers = {one};
    }

private:
    float m_reading;
};

}  // namespace

class TestControllerInput : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        QCOMPARE(SDL_InitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER), 0);
        QVERIFY(haptics::hasControllers());
    }
    void cleanupTestCase() { SDL_QuitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER); }

    void init()
    {
        m_input = std::make_unique<ControllerInput>(m_pedal);
        m_input->start();
    }
    void cleanup() { m_input.reset(); }

    void controllersAreListedAsTheyComeAndGo()
    {
        auto pedal = pedalNamed("A pedal");
        QVERIFY(pedal->isMade());
        QTRY_COMPARE(seen(*m_input, pedal->instance()).name, std::string("A pedal"));
        const Controller first = seen(*m_input, pedal->instance());
        QCOMPARE(first.axes.size(), std::size_t{3});
        QCOMPARE(first.presses.size(), std::size_t{2});
        QCOMPARE(first.guid.size(), std::size_t{32});
        QVERIFY(!first.isGamepad);
        pedal->setAxis(2, 0.5);
        QTRY_VERIFY(std::abs(seen(*m_input, pedal->instance()).axes.at(2) - 0.5F) < 0.001F);
        const int instance = pedal->instance();
        pedal.reset();
        QTRY_VERIFY(find(m_input->report(), instance) == nullptr);
    }

    void aGamepadHasNamedAxesAndButtons()
    {
        VirtualController pad("A pad", SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6, 15);
        QTRY_VERIFY(seen(*m_input, pad.instance()).isGamepad);
        pad.setAxis(SDL_CONTROLLER_AXIS_LEFTX, -1.0);
        pad.setAxis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 1.0);
        QTRY_COMPARE(seen(*m_input, pad.instance()).axes.at(kLeftStickX), -1.0F);
        QTRY_COMPARE(seen(*m_input, pad.instance()).axes.at(kRightTrigger), 1.0F);
        pad.setButton(SDL_CONTROLLER_BUTTON_Y, true);
        QTRY_VERIFY(seen(*m_input, pad.instance()).isHeld(kButtonY));
        pad.setButton(SDL_CONTROLLER_BUTTON_Y, false);
        QTRY_VERIFY(!seen(*m_input, pad.instance()).isHeld(kButtonY));
        QCOMPARE(seen(*m_input, pad.instance()).presses.at(kButtonY), 1U);
        QCOMPARE(seen(*m_input, pad.instance()).presses.at(kButtonA), 0U);
    }

    void theChosenPedalRunsTheBur()
    {
        auto pedal = pedalNamed("A pedal");
        QTRY_VERIFY(find(m_input->report(), pedal->instance()) != nullptr);
        pedal->setAxis(0, 1.0);
        QTRY_COMPARE(seen(*m_input, pedal->instance()).axes.at(0), 1.0F);
        QCOMPARE(m_input->report().pedal, PedalStage::NotChosen);
        QCOMPARE(m_pedal.percent(), std::uint8_t{0});
        m_input->setPedal(axisOf(seen(*m_input, pedal->instance())));
        QTRY_COMPARE(m_input->report().pedal, PedalStage::WaitsForRest);  // it was pressed when it was selected
        QCOMPARE(m_pedal.percent(), std::uint8_t{0});
        pedal->setAxis(0, -1.0);
        QTRY_COMPARE(m_input->report().pedal, PedalStage::Ready);
        pedal->setAxis(0, 1.0);
        QTRY_COMPARE(m_pedal.percent(), std::uint8_t{100});
        pedal->setAxis(0, 0.05);
        QTRY_COMPARE(m_pedal.percent(), std::uint8_t{50});
        QTRY_COMPARE(m_input->report().percent, 50);
        m_input->setPedal({});
        QTRY_COMPARE(m_pedal.percent(), std::uint8_t{0});
        QTRY_COMPARE(m_input->report().pedal, PedalStage::NotChosen);
    }

    void aPedalThatIsUnpluggedStopsTheBur()
    {
        auto pedal = pedalNamed("A pedal");
        QTRY_VERIFY(find(m_input->report(), pedal->instance()) != nullptr);
        m_input->setPedal(axisOf(seen(*m_input, pedal->instance())));
        QTRY_COMPARE(m_input->report().pedal, PedalStage::Ready);
        pedal->setAxis(0, 1.0);
        QTRY_COMPARE(m_pedal.percent(), std::uint8_t{100});
        const std::uint32_t before = m_input->report().unplugged;
        pedal.reset();
        QTRY_COMPARE(m_pedal.percent(), std::uint8_t{0});
        QTRY_COMPARE(m_input->report().pedal, PedalStage::Missing);
        QCOMPARE(m_input->report().unplugged, before + 1);
        // A pedal that is plugged in while pressed has no effect until it was released.
        pedal = std::make_unique<VirtualController>("A pedal", SDL_JOYSTICK_TYPE_THROTTLE, Uint16{3}, Uint16{2});
        pedal->setAxis(0, 1.0);
        QTRY_COMPARE(m_input->report().pedal, PedalStage::WaitsForRest);
        QCOMPARE(m_pedal.percent(), std::uint8_t{0});
        pedal->setAxis(0, -1.0);
        QTRY_COMPARE(m_input->report().pedal, PedalStage::Ready);
        pedal->setAxis(0, 1.0);
        QTRY_COMPARE(m_pedal.percent(), std::uint8_t{100});
    }

    void ofTwoPedalsTheChosenOneRunsTheBur()
    {
        auto first = pedalNamed("First pedal");
        auto second = pedalNamed("Second pedal");
        QTRY_VERIFY(find(m_input->report(), first->instance()) != nullptr);
        QTRY_VERIFY(find(m_input->report(), second->instance()) != nullptr);
        QVERIFY(seen(*m_input, first->instance()).guid != seen(*m_input, second->instance()).guid);
        m_input->setPedal(axisOf(seen(*m_input, second->instance())));
        QTRY_COMPARE(m_input->report().pedal, PedalStage::Ready);
        first->setAxis(0, 1.0);
        QTRY_COMPARE(seen(*m_input, first->instance()).axes.at(0), 1.0F);
        QCOMPARE(m_pedal.percent(), std::uint8_t{0});
        second->setAxis(0, 1.0);
        QTRY_COMPARE(m_pedal.percent(), std::uint8_t{100});
        first.reset();  // no effect, as it is not in use
        second->setAxis(0, 0.05);
        QTRY_COMPARE(m_pedal.percent(), std::uint8_t{50});
    }

    void aButtonRunsTheBurAtFullSpeed()
    {
        auto pedal = pedalNamed("A switch");
        QTRY_VERIFY(find(m_input->report(), pedal->instance()) != nullptr);
        m_input->setPedal({seen(*m_input, pedal->instance()).guid, -1, 1, {}});
        QTRY_COMPARE(m_input->report().pedal, PedalStage::Ready);
        pedal->setButton(1, true);
        QTRY_COMPARE(m_pedal.percent(), std::uint8_t{100});
        pedal->setButton(1, false);
        QTRY_COMPARE(m_pedal.percent(), std::uint8_t{0});
    }

    void anAxisThatTheControllerDoesNotHaveDoesNothing()
    {
        auto pedal = pedalNamed("A pedal");
        QTRY_VERIFY(find(m_input->report(), pedal->instance()) != nullptr);
        m_input->setPedal({seen(*m_input, pedal->instance()).guid, 12, -1, {}});
        QTRY_COMPARE(m_input->report().pedal, PedalStage::WaitsForRest);
        pedal->setAxis(0, 1.0);
        QTRY_COMPARE(seen(*m_input, pedal->instance()).axes.at(0), 1.0F);
        QCOMPARE(m_pedal.percent(), std::uint8_t{0});
    }

    void aPortThatCannotBeOpenedIsReported()
    {
        ControllerInput input(m_pedal, []() -> core::Result<std::unique_ptr<haptics::ControllerPort>> {
            return core::unexpected(core::ErrorCode::FileUnreadable, "No such thing here.");
        });
        input.start();
        QTRY_COMPARE(input.report().error.detail, std::string("No such thing here."));
        input.stop();
    }

    void anAxisThatIsNotANumberDoesNothing()
    {
        FootPedal line;
        ControllerInput input(line, []() -> core::Result<std::unique_ptr<haptics::ControllerPort>> {
            return std::make_unique<BrokenPort>(std::numeric_limits<float>::quiet_NaN());
        });
        input.setPedal({"one", 0, -1, {}});
        input.start();
        QTRY_COMPARE(input.report().pedal, PedalStage::WaitsForRest);
        QCOMPARE(line.percent(), std::uint8_t{0});
    }

private:
    FootPedal m_pedal;
    std::unique_ptr<ControllerInput> m_input;
};

QTEST_GUILESS_MAIN(TestControllerInput)
#include "tst_controller_input.moc"
