// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/presets/TrialCard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/kit/ScrollPane.h"
#include "ui/kit/Theme.h"
#include "ui/presets/FeedChart.h"
#include "ui/presets/SimplePanel.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/PresetTexts.h"
#include "ui/text/Texts.h"

namespace ui::presets {
namespace {

using namespace ui::kit;
using Answer = BlindTrial::Answer;

constexpr int kCardPx = 412;
constexpr int kHighestChartPx = 460;
constexpr int kLowestTrialPx = 200;
constexpr double kHardlyChance = 0.05;

/// Practice blocks that together cover all numbers of a preset. Enamel, dentin and soft decay are side by side in the
/// first block. The other blocks replace them.
constexpr std::array<core::settings::ToothKind, 3> kBlocks{{
    {},
    {false, core::settings::DecayKind::Firm},
    {true},
}};

/// Explains the significance of the answers to a reader without knowledge of statistics.
QString chanceWords(double p)
{
    const int times = std::max(1, static_cast<int>(std::lround(100.0 * p)));
    if (times >= 100)
        return TrialCard::tr("That says nothing: they came out as even as can be.");
    return p < kHardlyChance
               ? TrialCard::tr("That is hardly chance: tossing a coin comes out as uneven only %n time(s) in 100.",
                               nullptr, times)
               : TrialCard::tr("That may be chance: tossing a coin comes out as uneven %n time(s) in 100. Compare more "
                               "often to be sure.",
                               nullptr, times);
}

QPushButton* trialButton(const char* kind, const char* name, QWidget* parent)
{
    auto* made = new QPushButton(parent);
    made->setProperty("kind", kind);
    made->setObjectName(QLatin1String(name));
    made->setFocusPolicy(Qt::TabFocus);  // a click leaves the focus on the tooth view
    return made;
}

}  // namespace

TrialCard::TrialCard(QWidget* parent)
    : QFrame(parent), m_title(new QLabel(this)), m_words(new QLabel(this)), m_tuning(new QWidget(this)),
      m_dials(new SimplePanel(m_tuning)), m_blockChoice(new QWidget(this)), m_block(new QComboBox(m_blockChoice)),
      m_chart(new FeedChart(m_tuning)), m_reset(trialButton("quiet", "trialReset", this)), m_letters(new QWidget(this)),
      m_a(trialButton("segment", "trialA", m_letters)), m_b(trialButton("segment", "trialB", m_letters)),
      m_answers(new QWidget(this)), m_csv(trialButton("", "trialCsv", this)), m_end(trialButton("", "trialEnd", this)),
      m_back(trialButton("filled", "trialBack", this))
{
    setProperty("kind", "bar");
    setFixedWidth(kCardPx);
    m_title->setFont(typeface(kTitle, QFont::DemiBold));
    m_title->setWordWrap(true);
    m_title->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::PlainText);
    m_words->setObjectName(QStringLiteral("trialWords"));
    makeAnswers();
    connect(m_end, &QPushButton::clicked, this, &TrialCard::end);
    connect(m_back, &QPushButton::clicked, this, &TrialCard::done);
    connect(m_reset, &QPushButton::clicked, this, [this] {
        m_dials->setPreset({m_base}, m_asItWas);
        turn(m_asItWas);
    });
    connect(m_csv, &QPushButton::clicked, this, [this] {
        if (m_trial)
            emit csvRequested(m_trial->csv());
    });
    connect(m_dials, &SimplePanel::changed, this, &TrialCard::turn);
    makeBlockChoice();
    m_chart->setMinimumHeight(kLowestTrialPx);
    m_chart->setMaximumHeight(kHighestChartPx);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_reset);
    buttons->addWidget(m_csv);
    buttons->addStretch(1);
    buttons->addWidget(m_end);
    buttons->addWidget(m_back);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    column->setSpacing(kSpace2);
    column->addWidget(m_title);
    column->addWidget(m_words);
    column->addWidget(m_blockChoice);
    // In a low window, or with large text, the chart is below the dials and can be scrolled to.
    auto* tuning = new QVBoxLayout(m_tuning);
    tuning->setContentsMargins(0, 0, 0, 0);
    tuning->setSpacing(kSpace2);
    tuning->addWidget(m_dials);
    tuning->addWidget(m_chart, 1);
    tuning->addStretch(0);
    m_pane = new ScrollPane(m_tuning, QPalette::Window, this);
    column->addWidget(m_pane, 1);
    column->addWidget(m_letters);
    column->addWidget(m_answers);
    column->addLayout(buttons);
    column->addStretch(0);
    text::bindTranslation(this, [this] {
        m_reset->setText(tr("All as it was"));
        m_reset->setAccessibleName(tr("Set all sliders back to the preset"));
        m_csv->setText(tr("Save as CSV …"));
        m_csv->setAccessibleName(tr("Save the comparison as CSV"));
        m_end->setText(tr("End the comparison"));
        m_end->setAccessibleName(m_end->text());
        m_end->setToolTip(tr("What has been answered counts, and it is told which was which"));
        m_back->setText(tr("Back to the presets"));
        m_back->setAccessibleName(m_back->text());
        say();
    });
    hide();
}

/// Makes the buttons that choose the preset to feel, and those that say which of the two feels more like a tooth.
void TrialCard::makeAnswers()
{
    auto* letters = new QHBoxLayout(m_letters);
    letters->setContentsMargins(0, 0, 0, 0);
    for (QPushButton* letter : {m_a, m_b}) {
        letter->setCheckable(true);
        letter->setFont(typeface(kTitle, QFont::DemiBold));
        letters->addWidget(letter);
    }
    connect(m_a, &QPushButton::clicked, this, [this] { hold(Answer::A); });
    connect(m_b, &QPushButton::clicked, this, [this] { hold(Answer::B); });
    auto* answers = new QHBoxLayout(m_answers);
    answers->setContentsMargins(0, 0, 0, 0);
    auto* saysA = trialButton("", "trialSaysA", m_answers);
    auto* saysNone = trialButton("quiet", "trialSaysNone", m_answers);
    auto* saysB = trialButton("", "trialSaysB", m_answers);
    answers->addWidget(saysA);
    answers->addWidget(saysNone, 1);
    answers->addWidget(saysB);
    connect(saysA, &QPushButton::clicked, this, [this] { answer(Answer::A); });
    connect(saysNone, &QPushButton::clicked, this, [this] { answer(Answer::NoDifference); });
    connect(saysB, &QPushButton::clicked, this, [this] { answer(Answer::B); });
    text::bindTranslation(m_answers, [this, saysA, saysNone, saysB] {
        m_a->setText(QStringLiteral("A"));
        m_b->setText(QStringLiteral("B"));
        m_a->setAccessibleName(tr("Feel A"));
        m_b->setAccessibleName(tr("Feel B"));
        m_a->setToolTip(tr("Drill with the preset behind A from now on"));
        m_b->setToolTip(tr("Drill with the preset behind B from now on"));
        //: Which of two presets feels more like a tooth
        saysA->setText(tr("A does"));
        saysB->setText(tr("B does"));
        saysNone->setText(tr("No difference"));
        for (QPushButton* one : {saysA, saysNone, saysB})
            one->setAccessibleName(one->text());
    });
}

void TrialCard::makeBlockChoice()
{
    auto* row = new QHBoxLayout(m_blockChoice);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace2);
    auto* words = new QLabel(m_blockChoice);
    words->setForegroundRole(QPalette::PlaceholderText);
    m_block->setObjectName(QStringLiteral("trialBlock"));
    for (std::size_t k = 0; k < kBlocks.size(); ++k)
        m_block->addItem({});
    row->addWidget(words);
    row->addWidget(m_block, 1);
    connect(m_block, &QComboBox::activated, this, &TrialCard::takeBlock);
    text::bindTranslation(m_blockChoice, [this, words] {
        //: What the block is made of on which a hardness preset is tried
        words->setText(tr("Block of"));
        m_block->setAccessibleName(tr("What the block is made of"));
        const QStringList names{tr("enamel, dentin, soft decay"), tr("enamel, dentin, firm decay"),
                                tr("plastic throughout")};
        for (int k = 0; k < names.size(); ++k)
            m_block->setItemText(k, names[k]);
    });
}

void TrialCard::takeBlock()
{
    emit blockChosen(kBlocks.at(static_cast<std::size_t>(m_block->currentIndex())));
    if (isComparing())
        hold(m_held);
    else if (m_tuned)
        emit felt(*m_tuned);
}

void TrialCard::tune(const core::settings::FeelPreset& base, const core::settings::FeelPreset& preset)
{
    m_trial.reset();
    if (isHidden()) {  // otherwise the console has changed the preset
        m_asItWas = dialsFor(base, preset) ? base : preset;
        m_block->setCurrentIndex(0);
    }
    m_base = base;
    m_tuned = preset;
    m_dials->setPreset({base}, preset);
    say();
    draw();
    show();
}

void TrialCard::compare(const BlindTrial& trial)
{
    m_tuned.reset();
    m_trial = trial;
    m_block->setCurrentIndex(0);
    beginAnew();
    show();
    hold(Answer::A);
}

std::optional<core::settings::FeelPreset> TrialCard::tuned() const
{
    return m_tuned;
}

void TrialCard::follow(std::size_t bur, std::size_t handpiece, double cutMm3)
{
    m_chart->setTool(bur, handpiece);
    const bool hasCut = cutMm3 > m_cutMm3;
    m_cutMm3 = cutMm3;
    bool& with = m_held == Answer::A ? m_cutWithA : m_cutWithB;
    if (!hasCut || with)
        return;
    with = true;
    say();
}

void TrialCard::turn(const core::settings::FeelPreset& preset)
{
    m_tuned = preset;
    draw();
    emit felt(preset);
}

/// Shows the feed curve of the numbers that the dials set.
void TrialCard::draw()
{
    m_title->setText(text::presetWords(*m_tuned));
    setAccessibleName(m_title->text());
    m_chart->setPreset(*m_tuned, m_base);
}

void TrialCard::say()
{
    const bool isBlind = m_trial.has_value();
    const bool isOver = isBlind && m_trial->isOver();
    m_pane->setVisible(!isBlind);
    m_reset->setVisible(!isBlind);
    m_blockChoice->setVisible(!isOver);
    m_letters->setVisible(isBlind && !isOver);
    m_answers->setVisible(isBlind && !isOver);
    m_csv->setVisible(isOver && m_trial->trials() > 0);
    m_back->setVisible(!isComparing());
    m_end->setVisible(isComparing());
    if (!isBlind) {
        m_title->setText(m_tuned ? text::presetWords(*m_tuned) : QString());
        m_words->setText(tr("Drill: each slider is felt at once."));
    } else if (!isOver) {
        //: %1 of %2 trials
        m_title->setText(tr("Trial %1 of %2").arg(m_trial->trial()).arg(m_trial->trials()));
        m_words->setText(tr("Drill with A and with B, as often as you like. Which feels more like a tooth?"));
        m_answers->setEnabled(m_cutWithA && m_cutWithB);
        m_answers->setToolTip(m_answers->isEnabled() ? QString() : tr("First cut a little with both"));
    } else {
        const BlindTrial::Outcome outcome = m_trial->outcome();
        m_title->setText(tr("Compared"));
        const auto chosen = [](const core::settings::FeelPreset& preset, int times) {
            //: %1 is a hardness preset
            return tr("%1: chosen %n time(s).", nullptr, times).arg(text::presetWords(preset));
        };
        QString words = chosen(m_trial->first(), outcome.first) + u' ' + chosen(m_trial->second(), outcome.second);
        if (outcome.neither > 0)
            words += u' ' + tr("No difference: %n time(s).", nullptr, outcome.neither);
        if (outcome.first + outcome.second > 0)
            words += u'\n' + chanceWords(outcome.p);
        m_words->setText(m_trial->trials() > 0 ? words : tr("It was ended before anything was chosen."));
    }
    setAccessibleName(m_title->text());
}

/// Begins again with an uncut block.
void TrialCard::beginAnew()
{
    m_cutMm3 = std::numeric_limits<double>::max();
    m_cutWithA = false;
    m_cutWithB = false;
    say();
}

void TrialCard::hold(Answer letter)
{
    m_held = letter;
    m_a->setChecked(letter == Answer::A);
    m_b->setChecked(letter == Answer::B);
    emit felt(veiled(m_trial->behind(letter)));
}

void TrialCard::answer(Answer said)
{
    m_trial->answer(said);
    beginAnew();
    if (m_trial->isOver()) {
        emit felt(m_trial->behind(m_held));  // no longer hidden after the trial
        return;
    }
    emit freshBlockRequested();
    hold(Answer::A);
}

void TrialCard::end()
{
    m_trial->end();
    say();
    m_back->setFocus();  // it is now where the other button was
    emit felt(m_trial->behind(m_held));
}

}  // namespace ui::presets
