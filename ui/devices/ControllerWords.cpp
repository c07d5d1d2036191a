// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/ControllerWords.h"

#include <QCoreApplication>

#include "ui/text/ValidationTexts.h"

namespace ui::devices {
namespace {

using namespace core::session;

struct Controllers
{
    Q_DECLARE_TR_FUNCTIONS(ui::devices::Controllers)
};

}  // namespace

Sign signOf(const ControllerState& state)
{
    if (!state.isInBuild || !state.report.error.detail.empty())
        return Sign::Missing;
    switch (state.report.pedal) {
    case PedalStage::Ready:
        return Sign::Ready;
    case PedalStage::Missing:
    case PedalStage::WaitsForRest:
        return Sign::Attention;
    case PedalStage::NotChosen:
        break;
    }
    return state.report.controllers.empty() ? Sign::Off : Sign::Ready;
}

QString stateWords(const ControllerState& state)
{
    if (!state.isInBuild)
        return Controllers::tr("Not part of this program.");
    if (!state.report.error.detail.empty())
        return Controllers::tr("Pedals and gamepads cannot be read.");
    switch (state.report.pedal) {
    case PedalStage::Ready:
        return Controllers::tr("The pedal is ready.");
    case PedalStage::Missing:
        return Controllers::tr("The chosen pedal is not plugged in.");
    case PedalStage::WaitsForRest:
        return Controllers::tr("The pedal is pressed, or it sticks. Release it.");
    case PedalStage::NotChosen:
        break;
    }
    if (state.report.controllers.empty())
        return Controllers::tr("Nothing is plugged in.");
    QStringList names;
    for (const Controller& one : state.report.controllers)
        names << QString::fromStdString(one.name);
    //: %1: names of pedals and gamepads
    return Controllers::tr("Plugged in: %1").arg(names.join(QStringLiteral(", ")));
}

QString helpWords(const ControllerState& state)
{
    if (!state.isInBuild)
        return Controllers::tr("This program was built without SDL 2. The mouse and the keyboard work without it.");
    if (!state.report.error.detail.empty())
        return text::faultWords(core::wordsOf(state.report.error));
    switch (state.report.pedal) {
    case PedalStage::Ready:
        return Controllers::tr("The bur turns while the pedal is pressed, and faster the farther it is pressed.");
    case PedalStage::Missing:
        //: %1: name of a pedal
        return Controllers::tr("Plug in \"%1\". Until then, the bur runs without a pedal.").arg(state.pedalName);
    case PedalStage::WaitsForRest:
        return Controllers::tr(
            "The bur does not start before the pedal has been seen released. If it is released now, teach it again.");
    case PedalStage::NotChosen:
        break;
    }
    if (!state.report.controllers.empty())
        return Controllers::tr("Teach a pedal by one press: its travel then sets the speed of the bur. A gamepad works "
                               "as it comes.");
    return Controllers::tr("Plug in a foot pedal or a gamepad. A pedal that acts as a keyboard needs nothing here: let "
                           "it send Page Down.");
}

QString actionName(ControllerAction action)
{
    switch (action) {
    case ControllerAction::Drill:
        //: What a button does: the bur turns at full speed while it is pressed
        return Controllers::tr("Run the bur");
    case ControllerAction::Undo:
        return Controllers::tr("Undo");
    case ControllerAction::Redo:
        return Controllers::tr("Redo");
    case ControllerAction::Mirror:
        return Controllers::tr("Mirror");
    case ControllerAction::Centre:
        return Controllers::tr("Centre");
    case ControllerAction::NextView:
        //: What a button does: looks at the tooth from another side
        return Controllers::tr("Next view");
    case ControllerAction::NextBur:
        return Controllers::tr("Next bur");
    case ControllerAction::Grade:
        return Controllers::tr("Finish and grade");
    }
    return {};
}

QString axisName(const Controller& controller, std::size_t axis)
{
    if (controller.isGamepad) {
        switch (axis) {
        case kLeftStickX:
            return Controllers::tr("Left stick, sideways");
        case kLeftStickY:
            return Controllers::tr("Left stick, up and down");
        case kRightStickX:
            return Controllers::tr("Right stick, sideways");
        case kRightStickY:
            return Controllers::tr("Right stick, up and down");
        case kLeftTrigger:
            return Controllers::tr("Left trigger");
        case kRightTrigger:
            return Controllers::tr("Right trigger");
        default:
            break;
        }
    }
    //: Of a pedal; %1: a number
    return Controllers::tr("Axis %1").arg(axis + 1);
}

QString buttonName(const Controller& controller, std::size_t button)
{
    if (controller.isGamepad) {
        switch (button) {
        case kButtonA:
            return QStringLiteral("A");
        case kButtonB:
            return QStringLiteral("B");
        case kButtonX:
            return QStringLiteral("X");
        case kButtonY:
            return QStringLiteral("Y");
        case kButtonBack:
            //: A button of a gamepad
            return Controllers::tr("View");
        case kButtonGuide:
            //: A button of a gamepad
            return Controllers::tr("Guide");
        case kButtonStart:
            //: A button of a gamepad
            return Controllers::tr("Menu");
        case kLeftStickButton:
            //: The button in a stick of a gamepad
            return Controllers::tr("Left stick");
        case kRightStickButton:
            return Controllers::tr("Right stick");
        case kLeftShoulder:
            //: Left shoulder button of a gamepad, as it is printed on it
            return Controllers::tr("LB");
        case kRightShoulder:
            //: Right shoulder button of a gamepad, as it is printed on it
            return Controllers::tr("RB");
        case kPadUp:
            return QStringLiteral("↑");
        case kPadDown:
            return QStringLiteral("↓");
        case kPadLeft:
            return QStringLiteral("←");
        case kPadRight:
            return QStringLiteral("→");
        default:
            break;
        }
    }
    return QString::number(button + 1);
}

QStringList gamepadLayout()
{
    const auto row = [](const QString& control, const QString& does) { return control + u'\t' + does; };
    return {
        row(Controllers::tr("Left stick"), Controllers::tr("Moves the bur over the tooth")),
        row(Controllers::tr("Right stick"), Controllers::tr("Turns the view")),
        row(Controllers::tr("Right trigger"), Controllers::tr("Presses the bur down: the farther, the harder")),
        row(Controllers::tr("Left trigger"), Controllers::tr("Sets the speed of the bur, if it is the pedal")),
        //: The cross of four arrows on a gamepad
        row(Controllers::tr("Arrows"), Controllers::tr("Go through the buttons of the panel, or of the page")),
        row(QStringLiteral("A"), Controllers::tr("Presses the button that the arrows have gone to")),
        row(Controllers::tr("View"), Controllers::tr("Leads back to the tooth")),
    };
}

}  // namespace ui::devices
