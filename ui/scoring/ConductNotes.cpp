// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/ConductNotes.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/kit/Theme.h"
#include "ui/practice/InfractionCard.h"
#include "ui/text/Texts.h"

namespace ui::scoring {
namespace {

using namespace ui::kit;

constexpr std::size_t kShownBreaches = 2;
constexpr int kChipsARow = 2;

}  // namespace

ConductNotes::ConductNotes(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace2, 0, kSpace2, 0);
    column->setSpacing(kSpace1);
    m_head = new QHBoxLayout;
    m_head->setSpacing(kSpace2);
    column->addLayout(m_head);
    m_title = new QLabel(this);
    m_title->setFont(typeface(kSmall, QFont::DemiBold));
    m_title->setObjectName(QStringLiteral("breaches"));
    m_head->addWidget(m_title, 0, Qt::AlignTop);
    m_head->addStretch(1);
    m_facts = new QLabel(this);
    m_facts->setFont(typeface(kSmall));
    m_facts->setForegroundRole(QPalette::PlaceholderText);
    m_facts->setWordWrap(true);
    m_facts->setMinimumHeight(1);
    m_facts->setObjectName(QStringLiteral("conduct"));
    column->addWidget(m_facts);
}

/// Retranslates the notes before the event reaches the buttons, because the buttons are replaced.
void ConductNotes::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_process)
        retranslateUi();
}

QString ConductNotes::factsOf(const core::grading::Process& process, std::uint8_t aids)
{
    QStringList facts;
    //: Two times in minutes and seconds
    facts << tr("%1 in total, %2 of it cutting").arg(text::duration(process.totalS), text::duration(process.cuttingS));
    if (process.force)
        facts << tr("force: mean %1 N, maximum %2 N")
                     .arg(text::number(process.force->meanN, 1), text::number(process.force->largestN, 1));
    if (process.undos > 0)
        facts << tr("%n step(s) undone", nullptr, process.undos);
    facts << text::aidWords(aids);
    return facts.join(QStringLiteral(" · "));
}

void ConductNotes::setConduct(const core::grading::Process& process,
                              const std::vector<core::grading::Infraction>& infractions, std::uint8_t aids)
{
    m_process = process;
    m_infractions = infractions;
    m_aids = aids;
    m_showsAll = false;
    retranslateUi();
}

QString ConductNotes::countWords(const std::vector<core::grading::Infraction>& infractions)
{
    return infractions.empty() ? tr("No breach of the rules")
                               : tr("%n breach(es) of the rules", nullptr, static_cast<int>(infractions.size()));
}

QString ConductNotes::breachWords(const core::grading::Infraction& infraction)
{
    return tr("%1 at %2").arg(practice::breachName(infraction), text::duration(std::floor(infraction.seconds)));
}

void ConductNotes::retranslateUi()
{
    m_title->setText(countWords(m_infractions));
    m_facts->setText(factsOf(*m_process, m_aids));
    fillBreaches();
}

/// Shows the gravest rule violations in order of time, or all of them.
void ConductNotes::fillBreaches()
{
    delete m_breaches;
    m_breaches = nullptr;
    if (m_infractions.empty())
        return;
    std::vector<core::grading::Infraction> shown = m_infractions;
    if (!m_showsAll && shown.size() > kShownBreaches) {
        std::stable_sort(shown.begin(), shown.end(), [](const auto& a, const auto& b) { return a.breach < b.breach; });
        shown.resize(kShownBreaches - 1);
        std::stable_sort(shown.begin(), shown.end(), [](const auto& a, const auto& b) { return a.tick < b.tick; });
    }
    m_breaches = new QWidget(this);
    auto* grid = new QGridLayout(m_breaches);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kSpace1);
    grid->setColumnStretch(kChipsARow, 1);
    int place = 0;
    const auto add = [&](const QString& words, const QString& tip) {
        auto* chip = new QPushButton(words, m_breaches);
        chip->setProperty("kind", "chip");
        chip->setFont(typeface(kSmall, QFont::Medium));
        chip->setToolTip(tip);
        chip->setStatusTip(tip);
        chip->setAccessibleName(words);
        chip->setAccessibleDescription(tip);
        chip->setAutoDefault(true);
        grid->addWidget(chip, place / kChipsARow, place % kChipsARow, Qt::AlignLeft);
        ++place;
        return chip;
    };
    for (const core::grading::Infraction& infraction : shown) {
        QPushButton* chip = add(breachWords(infraction), tr("Replay the attempt from this moment"));
        connect(chip, &QPushButton::clicked, this, [this, at = infraction.seconds] { emit momentRequested(at); });
    }
    if (shown.size() < m_infractions.size()) {
        QPushButton* more = add(tr("%n more", "breaches", static_cast<int>(m_infractions.size() - shown.size())),
                                tr("Show every breach"));
        connect(
            more, &QPushButton::clicked, this,
            [this] {
                m_showsAll = true;
                fillBreaches();
            },
            Qt::QueuedConnection);
    }
    m_head->insertWidget(1, m_breaches);
}

}  // namespace ui::scoring
