// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/HandGuide.h"

#include <cmath>

#include <QAction>
#include <QApplication>
#include <QButtonGroup>
#include <QDoubleSpinBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/session/RestHeight.h"
#include "ui/devices/HandGuidePicture.h"
#include "ui/devices/StillnessTest.h"
#include "ui/kit/Actions.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::devices {
namespace {

using core::session::DeviceReport;
using core::session::DeviceSetup;
using core::session::DeviceStage;
using namespace ui::kit;

constexpr int kGuideSteps = 5;
constexpr int kWidestGuidePx = 900;
constexpr double kGuideScaleStep = 0.1;
constexpr double kSameHeightMm = 0.05;

QLabel* guideCaption(QWidget* parent)
{
    return kit::formWords({}, kSmall, QFont::Medium, QPalette::PlaceholderText, parent);
}

QString millimetres(double mm)
{
    return text::number(mm, 0);
}

}  // namespace

HandGuide::HandGuide(const Actions& actions, QWidget* parent)
    : QWidget(parent), m_otherHand(actions.otherHand), m_count(guideCaption(this)),
      m_title(kit::formWords({}, kTitle, QFont::DemiBold, QPalette::WindowText, this))
{
    setObjectName(QStringLiteral("handGuide"));
    m_title->setObjectName(QStringLiteral("guideTitle"));
    auto* content = new QWidget(this);
    content->setMaximumWidth(kWidestGuidePx);
    auto* inContent = new QVBoxLayout(content);
    inContent->setContentsMargins(0, 0, 0, 0);
    inContent->setSpacing(kSpace4);
    inContent->addWidget(makeCard(content));
    inContent->addLayout(makeButtons(content));
    inContent->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace4, 0, kSpace4, kSpace4);
    column->setSpacing(kSpace2);
    column->addWidget(m_count);
    column->addWidget(m_title);
    column->addWidget(new ScrollPane(content, QPalette::Window, this), 1);
    text::bindTranslation(this, [this] { showWords(); });
}

QWidget* HandGuide::makeCard(QWidget* parent)
{
    auto* card = new QFrame(parent);
    card->setProperty("kind", "card");
    card->setObjectName(QStringLiteral("handGuideCard"));
    m_picture = new HandGuidePicture(card);
    m_help = kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, card);
    m_help->setObjectName(QStringLiteral("guideHelp"));
    auto* words = new QVBoxLayout;
    words->setSpacing(kSpace4);
    words->addWidget(m_help);
    words->addWidget(makeHand(card));
    words->addWidget(makeRest(card));
    m_still = new StillnessTest(card);
    words->addWidget(m_still);
    words->addWidget(makeSummary(card));
    words->addStretch(1);
    auto* row = new QHBoxLayout(card);
    row->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    row->setSpacing(kSpace6);
    row->addWidget(m_picture, 0, Qt::AlignTop);
    row->addLayout(words, 1);
    return card;
}

QLayout* HandGuide::makeButtons(QWidget* parent)
{
    m_back = new QPushButton(parent);
    m_back->setObjectName(QStringLiteral("guideBack"));
    m_next = new QPushButton(parent);
    m_next->setObjectName(QStringLiteral("guideNext"));
    m_next->setProperty("kind", "filled");
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace2);
    row->addWidget(m_back);
    row->addWidget(m_next);
    row->addStretch(1);
    connect(m_back, &QPushButton::clicked, this, [this] {
        if (m_step == Step::Hand)
            emit closed();
        else
            showStep(static_cast<Step>(static_cast<int>(m_step) - 1));
    });
    connect(m_next, &QPushButton::clicked, this, [this] {
        if (m_step == Step::Summary)
            emit closed();
        else
            showStep(static_cast<Step>(static_cast<int>(m_step) + 1));
    });
    return row;
}

QWidget* HandGuide::makeHand(QWidget* parent)
{
    m_hand = new QWidget(parent);
    auto* row = new QHBoxLayout(m_hand);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace4);
    m_right = new QRadioButton(m_hand);
    m_right->setObjectName(QStringLiteral("rightHand"));
    m_left = new QRadioButton(m_hand);
    m_left->setObjectName(QStringLiteral("leftHand"));
    row->addWidget(m_right);
    row->addWidget(m_left);
    row->addStretch(1);
    connect(m_left, &QRadioButton::clicked, this, [this] { m_otherHand->setChecked(true); });
    connect(m_right, &QRadioButton::clicked, this, [this] { m_otherHand->setChecked(false); });
    connect(m_otherHand, &QAction::toggled, this, [this] { showStep(m_step); });
    return m_hand;
}

QWidget* HandGuide::makeRest(QWidget* parent)
{
    m_rest = new QWidget(parent);
    auto* inside = new QVBoxLayout(m_rest);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->setSpacing(kSpace2);
    m_height = kit::formWords({}, kBody, QFont::Medium, QPalette::WindowText, m_rest);
    m_height->setObjectName(QStringLiteral("gripHeight"));
    m_stored = kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, m_rest);
    m_stored->setObjectName(QStringLiteral("restHeight"));
    m_store = new QPushButton(m_rest);
    m_store->setObjectName(QStringLiteral("storeHeight"));
    m_middle = new QPushButton(m_rest);
    m_middle->setObjectName(QStringLiteral("middleHeight"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kSpace2);
    buttons->addWidget(m_store);
    buttons->addWidget(m_middle);
    buttons->addStretch(1);
    inside->addWidget(m_height);
    inside->addLayout(buttons);
    inside->addWidget(m_stored);
    connect(m_store, &QPushButton::clicked, this, [this] {
        if (const std::optional<double> mm = gripMm())
            storeHeight(*mm);
    });
    connect(m_middle, &QPushButton::clicked, this, [this] { storeHeight(0.0); });
    return m_rest;
}

QWidget* HandGuide::makeSummary(QWidget* parent)
{
    m_summary = new QWidget(parent);
    auto* inside = new QVBoxLayout(m_summary);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->setSpacing(kSpace1);
    auto* caption = guideCaption(m_summary);
    auto* help = guideCaption(m_summary);
    m_scale = kit::numberInput(DeviceSetup::kLeastScale, DeviceSetup::kMostScale, 1, {}, {}, m_summary);
    m_scale->setObjectName(QStringLiteral("guideScale"));
    m_scale->setSingleStep(kGuideScaleStep);
    m_scale->setFixedWidth(kit::kInputPx);
    inside->addWidget(caption);
    inside->addWidget(m_scale, 0, Qt::AlignLeft);
    inside->addWidget(help);
    connect(m_scale, &QDoubleSpinBox::valueChanged, this, [this](double scale) {
        DeviceSetup setup = m_setup;
        setup.scale = scale;
        setup.restMm = core::session::reachableRestMm(setup.restMm, scale);
        change(setup);
    });
    text::bindTranslation(m_summary, [this, caption, help] {
        //: How far the hand moves for one millimetre of the bur
        caption->setText(tr("Scale"));
        m_scale->setAccessibleName(caption->text());
        help->setText(tr("Movement of the hand for 1 mm of the bur, in millimetres. With more, drift and tremor of the "
                         "hand move the bur less."));
    });
    return m_summary;
}

void HandGuide::begin()
{
    m_hasForce = false;
    m_report = {};
    m_still->begin(false);
    setSetup({});
    showStep(Step::Hand);
}

void HandGuide::begin(const QString& deviceName, const DeviceSetup& setup, const DeviceReport& report)
{
    m_deviceName = deviceName;
    m_hasForce = true;
    m_still->begin(true);
    setSetup(setup);
    setReport(report);
    showStep(Step::Hand);
}

void HandGuide::setReport(const DeviceReport& report)
{
    m_report = report;
    const bool isReady = report.stage == DeviceStage::Ready;
    m_still->setBur(isReady ? std::optional(glm::dvec3(report.tipMm)) : std::nullopt);
    showHeight();
}

void HandGuide::setSetup(const DeviceSetup& setup)
{
    m_setup = setup;
    m_refusedMm.reset();
    const QSignalBlocker silent(m_scale);
    kit::showNumber(*m_scale, setup.scale);
    showWords();
}

void HandGuide::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_still->stop();
}

std::optional<double> HandGuide::gripMm() const
{
    if (m_report.stage != DeviceStage::Ready)
        return std::nullopt;
    return static_cast<double>(m_report.tipMm.z) * m_setup.scale + m_setup.restMm;
}

void HandGuide::storeHeight(double gripMm)
{
    DeviceSetup setup = m_setup;
    setup.restMm = core::session::reachableRestMm(gripMm, setup.scale);
    change(setup);
    if (std::abs(setup.restMm - gripMm) > kSameHeightMm)
        m_refusedMm = gripMm;
    showHeight();
}

void HandGuide::change(const DeviceSetup& setup)
{
    if (setup == m_setup)
        return;
    setSetup(setup);
    emit setupChanged(setup);
}

void HandGuide::showStep(Step step)
{
    if (step != m_step)
        m_still->stop();
    m_step = step;
    const QWidget* const focus = QApplication::focusWidget();
    const bool hasStartFocus = focus != nullptr && m_still->isAncestorOf(focus);
    const bool isLeft = m_otherHand->isChecked();
    (isLeft ? m_left : m_right)->setChecked(true);
    using Scene = HandGuidePicture::Scene;
    const Scene scene = step == Step::Hand     ? Scene::Hand
                        : step == Step::Screen ? Scene::Screen
                        : step == Step::Still  ? Scene::Still
                                               : Scene::Rest;
    m_picture->setScene(scene, isLeft, m_hasForce);
    m_hand->setVisible(step == Step::Hand);
    m_rest->setVisible(step == Step::Rest && m_hasForce);
    m_still->setVisible(step == Step::Still);
    m_summary->setVisible(step == Step::Summary && m_hasForce);
    showWords();
    if (step == Step::Still)
        m_still->focusStart();  // the hand that is measured presses no key
    else if (isVisible() && (hasStartFocus || (!m_next->hasFocus() && !m_back->hasFocus() && !m_left->hasFocus() &&
                                               !m_right->hasFocus())))
        m_next->setFocus();
}

void HandGuide::showWords()
{
    //: %1 and %2: numbers
    m_count->setText(tr("Step %1 of %2").arg(static_cast<int>(m_step) + 1).arg(kGuideSteps));
    m_title->setText(titleWords());
    m_right->setText(tr("Right hand"));
    m_left->setText(tr("Left hand"));
    m_help->setText(m_step == Step::Summary ? summaryWords() : helpWords());
    //: The height at which the hand is now
    m_store->setText(tr("Use this height"));
    m_middle->setText(tr("Use the middle"));
    m_back->setText(tr("Back"));
    m_next->setText(m_step == Step::Summary ? tr("Done") : tr("Next"));
    for (QAbstractButton* button : {static_cast<QAbstractButton*>(m_right), static_cast<QAbstractButton*>(m_left),
                                    static_cast<QAbstractButton*>(m_store), static_cast<QAbstractButton*>(m_middle),
                                    static_cast<QAbstractButton*>(m_back), static_cast<QAbstractButton*>(m_next)})
        button->setAccessibleName(button->text());
    m_next->setAccessibleDescription(m_title->text() + u' ' + m_help->text());
    showHeight();
}

QString HandGuide::titleWords() const
{
    switch (m_step) {
    case Step::Hand:
        return tr("Which hand do you work with?");
    case Step::Screen:
        return tr("Place the screen");
    case Step::Rest:
        return tr("Rest the hand");
    case Step::Still:
        return tr("Hold still");
    case Step::Summary:
        break;
    }
    return tr("Your place");
}

QString HandGuide::helpWords() const
{
    switch (m_step) {
    case Step::Hand:
        return tr("The handpiece comes from the side of this hand, and the light from the other one. Place the mouse, "
                  "the tablet or the device on this side.");
    case Step::Screen:
        return tr("Place it straight in front of you, 50 to 70 cm from your eyes. Its upper edge is at the height of "
                  "your eyes or a little below. Sit upright and let the shoulders hang.");
    case Step::Rest:
        return m_hasForce
                   ? tr("Put a box or a firm cushion in front of the device, so that the ring finger rests while you "
                        "hold the grip, as it does on a tooth. Hold the grip as if at the tooth. The top of the "
                        "tooth comes to the height that you store.")
                   : tr("Lay the forearm on the table, with the wrist straight. Hold a pen near its tip, and "
                        "rest the little finger beside it. Move a mouse with the fingers.");
    case Step::Still:
    case Step::Summary:
        break;
    }
    return m_hasForce ? tr("Hold the grip as if at the tooth, with a finger on the rest. Press Start with the other "
                           "hand and hold still for 8 seconds.")
                      : tr("Press Start with the space bar, or click it and leave the pointer there. Hold still for 8 "
                           "seconds. A pen hovers meanwhile.");
}

QString HandGuide::restWords() const
{
    const QString stored = millimetres(std::abs(m_setup.restMm));
    if (m_refusedMm)
        //: %1 and %2: millimetres
        return tr("Not all of the tooth could be reached from %1 mm, so %2 mm is stored. Move the rest or the device "
                  "instead.")
            .arg(millimetres(*m_refusedMm), millimetres(m_setup.restMm));
    if (std::abs(m_setup.restMm) < kSameHeightMm)
        return tr("The top of the tooth is at the middle of the work area.");
    return m_setup.restMm > 0.0
               //: %1: millimetres
               ? tr("The top of the tooth is %1 mm above the middle of the work area.").arg(stored)
               //: %1: millimetres
               : tr("The top of the tooth is %1 mm below the middle of the work area.").arg(stored);
}

QString HandGuide::summaryWords() const
{
    QStringList lines;
    //: %1: "Right hand"; %2: "Novint Falcon"
    lines << tr("%1, %2.").arg(m_otherHand->isChecked() ? m_left->text() : m_right->text(),
                               m_hasForce ? m_deviceName : tr("Mouse or pen"));
    if (m_hasForce)
        lines << restWords();
    lines << (m_still->result() ? m_still->resultWords() : tr("How still the hand is held was not measured."));
    return lines.join(u'\n');
}

void HandGuide::showHeight()
{
    const std::optional<double> grip = gripMm();
    m_picture->setHeights(grip, m_setup.restMm);
    m_store->setEnabled(grip.has_value());
    m_stored->setText(restWords());
    if (!grip)
        m_height->setText(tr("The device is not ready. Its entry on the page of devices says what to do."));
    else if (*grip >= 0.0)
        //: %1: millimetres
        m_height->setText(tr("The grip is %1 mm above the middle of the work area.").arg(millimetres(std::abs(*grip))));
    else
        //: %1: millimetres
        m_height->setText(tr("The grip is %1 mm below the middle of the work area.").arg(millimetres(std::abs(*grip))));
}

}  // namespace ui::devices
