// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/ControllerStore.h"

#include <array>

#include "ui/kit/AppSettings.h"

namespace app {
namespace {

using core::settings::PedalSettings;
using ui::devices::ControllerSettings;
using ui::kit::memory;

const QString kPedalKey = QStringLiteral("controllers/pedal");
const QString kPedalNameKey = QStringLiteral("controllers/pedal_name");

/// The keys of the actions, in the order of ui::devices::ControllerAction.
constexpr std::array<const char*, ui::devices::kControllerActions> kActionKeys{
    "drill", "undo", "redo", "mirror", "centre", "next_view", "next_bur", "grade"};

QString controllerKey(const QString& guid, const char* what)
{
    return QStringLiteral("controllers/%1/%2").arg(guid, QLatin1String(what));
}

/// Sets `value` to the stored number, if there is one between `low` and `high`.
template <class T>
void recallWithin(const QSettings& stored, const QString& key, T low, T high, T& value)
{
    bool isNumber = false;
    const double number = stored.value(key).toDouble(&isNumber);
    if (isNumber && number >= static_cast<double>(low) && number <= static_cast<double>(high))
        value = static_cast<T>(number);
}

}  // namespace

std::optional<ControllerSettings> storedController(const QString& guid)
{
    const QSettings stored = memory();
    if (!stored.contains(controllerKey(guid, "axis")))
        return std::nullopt;
    ControllerSettings settings;
    constexpr int kMostAxis = static_cast<int>(core::session::kMostControllerAxes) - 1;
    constexpr int kMostButton = static_cast<int>(core::session::kMostControllerButtons) - 1;
    PedalSettings& shape = settings.shape;
    recallWithin(stored, controllerKey(guid, "axis"), ui::devices::kNoAxis, kMostAxis, settings.axis);
    recallWithin(stored, controllerKey(guid, "rest"), -1.0, 1.0, shape.restReading);
    recallWithin(stored, controllerKey(guid, "full"), -1.0, 1.0, shape.fullReading);
    recallWithin(stored, controllerKey(guid, "dead_zone"), 0.0, PedalSettings::kMostDeadZone, shape.deadZone);
    recallWithin(stored, controllerKey(guid, "curve"), PedalSettings::kLeastCurve, PedalSettings::kMostCurve,
                 shape.curve);
    shape.isInverted = ui::kit::recalled(stored, controllerKey(guid, "inverted"), false);
    for (std::size_t k = 0; k < kActionKeys.size(); ++k)
        recallWithin(stored, controllerKey(guid, kActionKeys.at(k)), ui::devices::kNoButton, kMostButton,
                     settings.buttons.at(k));
    return settings;
}

void storeController(const QString& guid, const ControllerSettings& settings)
{
    QSettings stored = memory();
    stored.setValue(controllerKey(guid, "axis"), settings.axis);
    stored.setValue(controllerKey(guid, "rest"), settings.shape.restReading);
    stored.setValue(controllerKey(guid, "full"), settings.shape.fullReading);
    stored.setValue(controllerKey(guid, "dead_zone"), settings.shape.deadZone);
    stored.setValue(controllerKey(guid, "curve"), settings.shape.curve);
    stored.setValue(controllerKey(guid, "inverted"), settings.shape.isInverted);
    for (std::size_t k = 0; k < kActionKeys.size(); ++k)
        stored.setValue(controllerKey(guid, kActionKeys.at(k)), settings.buttons.at(k));
}

ChosenPedal storedPedal()
{
    const QSettings stored = memory();
    return {stored.value(kPedalKey).toString(), stored.value(kPedalNameKey).toString()};
}

void storePedal(const ChosenPedal& pedal)
{
    QSettings stored = memory();
    stored.setValue(kPedalKey, pedal.guid);
    stored.setValue(kPedalNameKey, pedal.name);
}

}  // namespace app
