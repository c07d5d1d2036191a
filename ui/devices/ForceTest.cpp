// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/ForceTest.h"

#include <QGridLayout>
#include <QPushButton>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

constexpr int kButtonPx = 84;

struct Direction
{
    const char* objectName;
    const char* words;
    glm::dvec3 towards;
    int row;
    int column;
};

/// In the order of the rows and of the Tab key.
const std::array<Direction, 6> kDirections{{
    {"pushAway", QT_TRANSLATE_NOOP("ui::devices::ForceTest", "Away"), {0.0, 1.0, 0.0}, 0, 1},
    {"pushUp", QT_TRANSLATE_NOOP("ui::devices::ForceTest", "Up"), {0.0, 0.0, 1.0}, 0, 3},
    {"pushLeft", QT_TRANSLATE_NOOP("ui::devices::ForceTest", "Left"), {-1.0, 0.0, 0.0}, 1, 0},
    {"pushRight", QT_TRANSLATE_NOOP("ui::devices::ForceTest", "Right"), {1.0, 0.0, 0.0}, 1, 2},
    {"pushTowards", QT_TRANSLATE_NOOP("ui::devices::ForceTest", "Towards you"), {0.0, -1.0, 0.0}, 2, 1},
    {"pushDown", QT_TRANSLATE_NOOP("ui::devices::ForceTest", "Down"), {0.0, 0.0, -1.0}, 2, 3},
}};

}  // namespace

ForceTest::ForceTest(QWidget* parent) : QWidget(parent)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kit::kSpace1);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    for (const int column : {0, 1, 2, 3})
        grid->setColumnMinimumWidth(column, kButtonPx);
    for (std::size_t k = 0; k < kDirections.size(); ++k) {
        const Direction& direction = kDirections.at(k);
        auto* button = new QPushButton(this);
        button->setObjectName(QLatin1String(direction.objectName));
        button->setProperty("kind", "segment");
        grid->addWidget(button, direction.row, direction.column);
        m_buttons.at(k) = button;
    }
    text::bindTranslation(this, [this] {
        for (std::size_t k = 0; k < kDirections.size(); ++k) {
            const QString words = tr(kDirections.at(k).words);
            m_buttons.at(k)->setText(words);
            //: %1: a direction, such as "Left"
            m_buttons.at(k)->setAccessibleName(tr("Push the hand: %1").arg(words));
        }
    });
}

glm::dvec3 ForceTest::force() const
{
    for (std::size_t k = 0; k < kDirections.size(); ++k)
        if (m_buttons.at(k)->isDown())
            return kTestN * kDirections.at(k).towards;
    return glm::dvec3(0.0);
}

}  // namespace ui::devices
