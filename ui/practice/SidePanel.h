// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QElapsedTimer>
#include <QFrame>

#include "core/guidance/Margin.h"
#include "core/imaging/Section.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "lessons/Lesson.h"
#include "ui/render/Look.h"

class QLabel;
class QBoxLayout;
class QVBoxLayout;

namespace ui::kit {
class Actions;
class ForceBar;
class MaterialSwatch;
class TabularDigitsLabel;
}  // namespace ui::kit

namespace ui::tooth {
class ToothView;
}

namespace ui::practice {

class DrillSwitch;
class HandControls;

/// The panel beside the tooth: the drill switch, the pointer controls, the live figures and the burs.
class SidePanel : public QFrame
{
    Q_OBJECT
public:
    /// @param view  the panel controls its pointer settings; must outlive the panel
    SidePanel(kit::Actions& actions, tooth::ToothView& view, QWidget* parent);

    /// Shows the newest figures. Call once per frame. Text changes slowly enough to read.
    void setFigures(const core::servo::ServoState& servo, const core::session::SessionState& session,
                    const core::imaging::DepthReading& reading);
    /// Sets the lesson, which determines the figures that are shown.
    /// @param lesson  null: practice without a lesson
    void setLesson(const lessons::Lesson* lesson);
    /// Shows the distance from the bur to tissue that must be preserved, mm, and the progress towards the ideal.
    /// @param marginMm, progress  empty: not shown
    void setGuide(const std::optional<double>& marginMm, const std::optional<core::guidance::Progress>& progress);
    /// Sets the palette of the discs beside the names of tissues.
    void setColours(render::Palette colours);
    /// Sets whether the depth is shown, and whether the distance to the pulp is. Without the latter, users need a
    /// radiograph.
    void setTold(bool depth, bool pulp);
    /// Hides everything that names a tissue, for exercises in which tissues are recognised by feel.
    void setBlindfold(bool on);
    [[nodiscard]] HandControls& hand() { return *m_hand; }

private:
    void addFigures(QVBoxLayout* column, QWidget* content);
    void addVolumes(QVBoxLayout* column, QWidget* content);
    void retranslateUi();
    void showHealth(const core::servo::ServoState& servo);
    void nameFigures();
    void showFigures();
    [[nodiscard]] QString nameOf(core::terrain::Material material) const;
    struct Figure
    {
        QWidget* block;
        QString caption;
        QLabel* words;
        kit::TabularDigitsLabel* value;
    };
    /// @param before  placed in front of the value; may be null
    static Figure addFigure(QBoxLayout* layout, const char* objectName, QWidget* before = nullptr);
    static void name(Figure& figure, const QString& caption);
    static void setFigure(const Figure& figure, const QString& text, const QString& unit, const QColor& colour = {});

    Figure m_material{};
    Figure m_force{};
    Figure m_depth{};
    Figure m_pulp{};
    Figure m_decay{};
    Figure m_margin{};
    QLabel* m_removedWords = nullptr;
    QLabel* m_burWords = nullptr;
    QLabel* m_overcutWords = nullptr;
    lessons::ShownTarget m_target = lessons::ShownTarget::Decay;
    kit::MaterialSwatch* m_swatch = nullptr;
    kit::ForceBar* m_forceBar = nullptr;
    std::array<kit::TabularDigitsLabel*, core::terrain::kMaterialCount> m_removed{};
    std::array<QLabel*, core::terrain::kMaterialCount> m_removedNames{};
    kit::MaterialSwatch* m_enamelSwatch = nullptr;
    kit::TabularDigitsLabel* m_rpm = nullptr;
    kit::TabularDigitsLabel* m_overcut = nullptr;
    QWidget* m_overcutRow = nullptr;
    QLabel* m_health = nullptr;
    QWidget* m_removedBlock = nullptr;
    bool m_isBlock = false;
    bool m_hasPulp = false;    ///< m_pulp has a value
    bool m_hasMargin = false;  ///< m_margin has a value
    bool m_tellsDepth = true;
    bool m_tellsPulp = true;
    bool m_blindfold = false;
    HandControls* m_hand = nullptr;
    QElapsedTimer m_sinceWords;
};

}  // namespace ui::practice
