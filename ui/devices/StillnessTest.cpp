// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/StillnessTest.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <QCursor>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>

#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::devices {
namespace {

using namespace ui::kit;
using core::session::Stillness;
using core::session::StillnessCheck;

constexpr int kLookMs = 33;
constexpr int kProgressSteps = 100;
constexpr double kScreenMmPerInch = 25.4;
constexpr int kStillDecimals = 2;

/// Limits for a steady hand; see docs/hand-and-rest.md for the reasons.
constexpr Stillness kSteadyOnTooth{0.5, 0.15};
constexpr Stillness kSteadyOnScreen{3.0, 0.5};

double steadySeconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

StillnessTest::StillnessTest(QWidget* parent)
    : QWidget(parent), m_clock(steadySeconds),
      m_words(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this)), m_progress(new QProgressBar(this)),
      m_start(new QPushButton(this))
{
    m_words->setObjectName(QStringLiteral("stillWords"));
    m_progress->setObjectName(QStringLiteral("stillProgress"));
    m_progress->setRange(0, kProgressSteps);
    m_progress->setTextVisible(false);
    m_start->setObjectName(QStringLiteral("stillStart"));
    m_look.setInterval(kLookMs);
    m_look.setTimerType(Qt::PreciseTimer);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    column->addWidget(m_start, 0, Qt::AlignLeft);
    column->addWidget(m_progress);
    column->addWidget(m_words);
    connect(m_start, &QPushButton::clicked, this, [this] {
        if (m_check)
            stop();
        else
            start();
    });
    connect(&m_look, &QTimer::timeout, this, &StillnessTest::look);
    text::bindTranslation(this, [this] {
        m_progress->setAccessibleName(tr("Time that is over"));
        showWords();
    });
}

void StillnessTest::begin(bool hasForce)
{
    m_hasForce = hasForce;
    m_burMm.reset();
    m_result.reset();
    m_failure = nullptr;
    stop();
}

void StillnessTest::focusStart()
{
    m_start->setFocus();
}

void StillnessTest::setBur(std::optional<glm::dvec3> burMm)
{
    const bool couldStart = m_burMm.has_value();
    m_burMm = burMm;
    if (couldStart != burMm.has_value())
        showWords();
}

void StillnessTest::stop()
{
    m_look.stop();
    m_check.reset();
    m_progress->setValue(0);
    showWords();
}

void StillnessTest::start()
{
    m_result.reset();
    m_failure = nullptr;
    m_check.emplace();
    m_startS = m_clock();
    m_progress->setValue(0);
    m_look.start();
    showWords();
}

void StillnessTest::fail(const char* words)
{
    m_failure = words;
    stop();
}

void StillnessTest::look()
{
    if (m_hasForce && !m_burMm) {
        fail(QT_TR_NOOP("The device stopped responding. Start again when it is ready."));
        return;
    }
    const double seconds = m_clock() - m_startS - kLeadS;
    if (seconds < 0.0)
        return;
    m_check->add(seconds, m_hasForce ? *m_burMm : pointerMm());
    m_progress->setValue(static_cast<int>(std::lround(kProgressSteps * m_check->progress())));
    showWords();
    if (!m_check->isOver())
        return;
    m_result = m_check->result();
    if (m_result)
        stop();
    else
        fail(QT_TR_NOOP("Too few positions were measured. Close other programs and start again."));
}

glm::dvec3 StillnessTest::pointerMm() const
{
    const QPoint at = QCursor::pos();
    const double mmPerPixel = kScreenMmPerInch / std::max(1.0, screen()->physicalDotsPerInch());
    return {mmPerPixel * at.x(), mmPerPixel * at.y(), 0.0};
}

QString StillnessTest::resultWords() const
{
    if (!m_result)
        return {};
    const QString drift = text::number(m_result->driftMm, kStillDecimals);
    const QString tremor = text::number(m_result->tremorMm, kStillDecimals);
    //: %1 and %2: millimetres
    const QString figures = m_hasForce ? tr("On the tooth, the bur drifted by %1 mm and trembled by %2 mm.")
                                       : tr("On the screen, the pointer drifted by %1 mm and trembled by %2 mm.");
    const Stillness& steady = m_hasForce ? kSteadyOnTooth : kSteadyOnScreen;
    QString advice;
    if (m_result->driftMm > steady.driftMm)
        advice = tr("The hand drifts: support the forearm, and try another height of the rest.");
    else if (m_result->tremorMm > steady.tremorMm)
        advice = m_hasForce ? tr("The hand trembles: hold the grip loosely, put a finger on the rest, or choose a "
                                 "larger scale on the next step.")
                            : tr("The hand trembles: put the wrist on the table, or zoom in at the tooth.");
    else
        advice = tr("That is steady.");
    return figures.arg(drift, tremor) + u' ' + advice;
}

void StillnessTest::showWords()
{
    m_start->setText(m_check ? tr("Cancel") : m_result ? tr("Once more") : tr("Start"));
    m_start->setAccessibleName(m_start->text());
    m_progress->setVisible(m_check.has_value());
    m_start->setEnabled(!m_hasForce || m_burMm);
    if (m_check && m_progress->value() == 0)
        m_words->setText(tr("Get ready."));
    else if (m_check)
        m_words->setText(tr("Hold still."));
    else if (m_result)
        m_words->setText(resultWords());
    else if (m_failure != nullptr)
        m_words->setText(tr(m_failure));
    else
        m_words->setText(m_hasForce && !m_burMm ? tr("This can be tried when the device is ready.") : QString());
}

}  // namespace ui::devices
