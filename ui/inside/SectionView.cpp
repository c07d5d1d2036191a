// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inside/SectionView.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>

#include "core/bur/Bur.h"
#include "ui/inside/SectionPainter.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::inside {
namespace {

using namespace kit;

constexpr qint64 kPaintEveryMs = 30;
/// Paints at most every second frame of the view, so that a slow view does not become slower.
constexpr int kFramesBetween = 2;
/// Faster changes would blur the last digit.
constexpr qint64 kFiguresEveryMs = 80;
constexpr double kStirMm = 0.005;  ///< a third of a pixel; smaller moves are invisible
constexpr int kHalfTurnDeg = 180;
constexpr int kAlongYDeg = 90;
constexpr int kTurnDeg = 15;

double radians(int degrees)
{
    return degrees * std::numbers::pi / kHalfTurnDeg;
}

}  // namespace

/// The widget in which the section is painted.
class SectionCanvas : public QWidget
{
public:
    explicit SectionCanvas(QWidget* parent) : QWidget(parent)
    {
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
        setMinimumHeight(120);
        setAttribute(Qt::WA_OpaquePaintEvent);
    }

    SectionScene scene;

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        if (scene.tooth != nullptr)
            paintSection(painter, rect(), scene);
        else
            painter.fillRect(rect(), palette().color(QPalette::Window));
    }
};

SectionView::SectionView(QWidget* parent) : QFrame(parent), m_canvas(new SectionCanvas(this))
{
    setProperty("kind", "bar");
    text::bindTranslation(this, [this] { setAccessibleName(tr("Section through the bur")); });
    text::bindTranslation(m_canvas, [this] { m_canvas->setAccessibleName(tr("Picture of the section")); });

    // The captions are set again when there is a tooth.
    const auto choice = [this](int degrees) {
        auto* button = new QPushButton(this);
        button->setProperty("kind", "segment");
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        text::bindTranslation(button,
                              [button] { button->setToolTip(tr("Cut the tooth in this direction, through the bur")); });
        connect(button, &QPushButton::clicked, this, [this, degrees] { setAngle(degrees); });
        return button;
    };
    m_alongY = choice(kAlongYDeg);
    m_alongX = choice(0);
    m_alongY->setObjectName(QStringLiteral("sectionAlongY"));
    m_alongX->setObjectName(QStringLiteral("sectionAlongX"));
    auto* planes = new QHBoxLayout;
    planes->setSpacing(kSpace2);
    planes->addWidget(m_alongY, 1);
    planes->addWidget(m_alongX, 1);

    makeFigures();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace2, kSpace4, kSpace2, kSpace4);
    column->setSpacing(kSpace2);
    column->addLayout(planes);
    column->addLayout(makeAngle());
    column->addWidget(m_canvas, 1);
    column->addWidget(m_figures);
    setAngle(kAlongYDeg);
    text::bindTranslation(this, [this] {
        nameSides();
        showFigures({}, {});
        m_sinceFigures.invalidate();
    });
}

/// Makes the slider that turns the section, with its caption and value.
QLayout* SectionView::makeAngle()
{
    m_angle = new QSlider(Qt::Horizontal, this);
    m_angle->setRange(0, kHalfTurnDeg - 1);
    m_angle->setPageStep(kTurnDeg);
    m_angle->setFocusPolicy(Qt::TabFocus);
    m_angle->setObjectName(QStringLiteral("sectionAngle"));
    text::bindTranslation(m_angle, [this] {
        m_angle->setAccessibleName(tr("Angle of the section, degrees"));
        m_angle->setToolTip(tr("Turn the section about the bur (Shift+X: by 15 degrees)"));
        m_angle->setStatusTip(m_angle->toolTip());
    });
    m_angleText = new TabularDigitsLabel(this);
    m_angleText->setFont(typeface(kBody, QFont::Medium));
    m_angleText->setAlignment(Qt::AlignRight);
    m_angleText->setText(QStringLiteral("180°"));
    m_angleText->setFixedWidth(m_angleText->sizeHint().width());
    connect(m_angle, &QSlider::valueChanged, this, &SectionView::setAngle);
    auto* turned = new QHBoxLayout;
    turned->setSpacing(kSpace2);
    auto* turnedWords = new QLabel(this);
    text::bindTranslation(turnedWords, [turnedWords] { turnedWords->setText(tr("Turned by")); });
    turnedWords->setFont(typeface(kSmall));
    turnedWords->setForegroundRole(QPalette::PlaceholderText);
    turnedWords->setBuddy(m_angle);
    turned->addWidget(turnedWords);
    turned->addWidget(m_angle, 1);
    turned->addWidget(m_angleText);
    return turned;
}

void SectionView::makeFigures()
{
    m_figures = new QWidget(this);
    auto* figures = new QGridLayout(m_figures);
    figures->setContentsMargins(0, 0, 0, 0);
    figures->setHorizontalSpacing(kSpace4);
    figures->setVerticalSpacing(2);
    figures->setColumnStretch(0, 1);
    int row = 0;
    const auto addFigure = [&](const char* caption, const char* objectName, const char* tip) {
        auto* words = new QLabel(this);
        words->setForegroundRole(QPalette::PlaceholderText);
        words->setWordWrap(true);
        auto* value = new TabularDigitsLabel(this);
        value->setFont(typeface(kBody, QFont::Medium));
        value->setAlignment(Qt::AlignRight);
        value->setObjectName(QString::fromLatin1(objectName));
        text::bindTranslation(words, [words, value, caption, tip] {
            words->setText(tr(caption));
            words->setToolTip(brokenIntoLines(tr(tip)));
            value->setToolTip(words->toolTip());
        });
        figures->addWidget(words, row, 0);
        figures->addWidget(value, row++, 1);
        return value;
    };
    m_depth = addFigure(QT_TR_NOOP("Depth below original surface"), "sectionDepth",
                        QT_TR_NOOP("Vertical depth of the tip below the original surface."));
    m_dentin = addFigure(
        QT_TR_NOOP("Dentin left over the pulp"), "sectionDentin",
        QT_TR_NOOP("Sound dentin between the cut and the pulp straight below the tip. A dash: no pulp there."));
    m_down = addFigure(QT_TR_NOOP("Tip straight down to the pulp"), "sectionDown",
                       QT_TR_NOOP("Straight down from the tip of the bur. A dash: no pulp there."));
    m_nearest = addFigure(QT_TR_NOOP("Bur to the nearest pulp"), "sectionNearest",
                          QT_TR_NOOP("The shortest way in any direction, also out of the plane of the picture."));
}

int SectionView::angleDeg() const
{
    return m_angle->value();
}

void SectionView::setColours(render::Palette colours)
{
    m_canvas->scene.palette = colours;
    m_canvas->update();
}

void SectionView::setIdeal(core::grading::IdealTop ideal)
{
    m_canvas->scene.ideal = std::move(ideal);
    m_canvas->update();
}

void SectionView::setHeld(std::optional<glm::dvec3> tipMm)
{
    m_held = tipMm;
}

void SectionView::setFiguresShown(bool shown)
{
    m_figures->setVisible(shown);
}

void SectionView::turn()
{
    setAngle((angleDeg() / kTurnDeg + 1) * kTurnDeg % kHalfTurnDeg);
}

void SectionView::showAlong(double angleRad)
{
    const auto degrees = static_cast<int>(std::lround(angleRad / radians(1)));
    setAngle((degrees % kHalfTurnDeg + kHalfTurnDeg) % kHalfTurnDeg);
}

void SectionView::setAngle(int degrees)
{
    m_angle->setValue(degrees);
    m_angleText->setText(QStringLiteral("%1°").arg(degrees));
    m_alongX->setChecked(degrees == 0);
    m_alongY->setChecked(degrees == kAlongYDeg);
    m_canvas->scene.plane.angleRad = radians(degrees);
    m_canvas->update();
}

void SectionView::nameSides()
{
    if (!m_anatomy) {
        m_alongY->setAccessibleName(tr("Section along y"));
        m_alongX->setAccessibleName(tr("Section along x"));
        return;
    }
    m_alongX->setText(text::planeAlongX(*m_anatomy));
    m_alongY->setText(text::planeAlongY(*m_anatomy));
    for (QPushButton* button : {m_alongX, m_alongY})
        button->setAccessibleName(tr("Section: %1").arg(button->text()));
}

void SectionView::follow(const core::terrain::Tooth* tooth, std::uint64_t revision,
                         const core::servo::ServoState& servo, const core::imaging::DepthReading& reading)
{
    SectionScene& scene = m_canvas->scene;
    // The old pointer may be dangling, so it is replaced in every case.
    scene.tooth = tooth;
    if (tooth == nullptr || !isVisible())
        return;
    const bool otherTooth = tooth->anatomy != m_anatomy;
    const glm::dvec3 tipMm = m_held.value_or(servo.anchorMm);
    const bool hasBur = servo.tick > 0 && servo.burIndex < core::bur::burs().size();
    const bool stirred = otherTooth || revision != m_revision || hasBur != m_hasBur || servo.burIndex != m_bur ||
                         (hasBur && glm::length(tipMm - m_tipMm) > kStirMm);
    if (!m_sinceFigures.isValid() || m_sinceFigures.elapsed() >= kFiguresEveryMs) {
        m_sinceFigures.start();
        showFigures(servo, reading);
    }
    ++m_framesSince;
    const bool tooSoon =
        m_sincePaint.isValid() && (m_sincePaint.elapsed() < kPaintEveryMs || m_framesSince < kFramesBetween);
    if (!stirred || (!otherTooth && tooSoon))
        return;
    m_sincePaint.start();
    m_framesSince = 0;
    if (otherTooth) {
        m_anatomy = tooth->anatomy;
        nameSides();
    }
    m_revision = revision;
    m_hasBur = hasBur;
    m_bur = servo.burIndex;
    m_tipMm = tipMm;
    scene.bur = hasBur ? &core::bur::burs()[servo.burIndex] : nullptr;
    scene.tipMm = tipMm;
    // Without a bur the cut is through the middle of the tooth.
    scene.plane.throughMm = hasBur ? glm::dvec2(tipMm) : tooth->grid().middleMm();
    scene.downToPulpMm = hasBur && !m_held ? reading.downToPulpMm : std::nullopt;
    m_canvas->update();
}

void SectionView::showFigures(const core::servo::ServoState& servo, const core::imaging::DepthReading& reading)
{
    const QColor quiet = palette().color(QPalette::PlaceholderText);
    const auto show = [&](TabularDigitsLabel* label, const std::optional<double>& mm) {
        label->setText(mm ? text::number(*mm, 2) : QStringLiteral("–"), QStringLiteral("mm"));
        label->setColour(mm ? QColor() : quiet);
    };
    show(m_depth, reading.overTooth ? std::optional(reading.depthMm) : std::nullopt);
    show(m_dentin, reading.dentinOverPulpMm);
    show(m_down, servo.tick > 0 ? reading.downToPulpMm : std::nullopt);
    show(m_nearest, servo.tick > 0 ? reading.toPulpMm : std::nullopt);
}

}  // namespace ui::inside
