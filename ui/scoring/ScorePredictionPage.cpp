// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/ScorePredictionPage.h"

#include <algorithm>

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QVBoxLayout>

#include "ui/kit/ScrollPane.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/Texts.h"

namespace ui::scoring {
namespace {

using namespace ui::kit;

constexpr int kCardWidthPx = 620;
constexpr int kTenthsAStep = 10;
constexpr int kBeginAt = 50;
constexpr std::size_t kMostCriteria = 3;  ///< number of criteria offered as answers

}  // namespace

ScorePredictionPage::ScorePredictionPage(const Actions& actions, QWidget* parent) : Page(actions, parent)
{
    auto* content = new QWidget(this);
    auto* outer = new QHBoxLayout(content);
    auto* column = new QVBoxLayout;
    column->setSpacing(kSpace4);
    auto* block = new QWidget(content);
    block->setMaximumWidth(kCardWidthPx);
    block->setLayout(column);
    outer->addStretch(1);
    outer->addWidget(block, 1000);
    outer->addStretch(1);

    auto* question = new QLabel(block);
    text::bindTranslation(question, [question] { question->setText(tr("How many points do you expect?")); });
    question->setFont(typeface(kFigure, QFont::DemiBold));
    question->setWordWrap(true);
    column->addStretch(1);
    column->addWidget(question);
    m_mark = new QLabel(block);
    m_mark->setTextFormat(Qt::PlainText);
    m_mark->setForegroundRole(QPalette::PlaceholderText);
    m_mark->setWordWrap(true);
    column->addWidget(m_mark);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace4);
    m_slider = new QSlider(Qt::Horizontal, block);
    m_slider->setRange(0, ::lessons::kFullTenths / kTenthsAStep);
    m_slider->setPageStep(5);
    m_slider->setObjectName(QStringLiteral("expected"));
    m_value = new TabularDigitsLabel(block);
    m_value->setFont(typeface(kFigure, QFont::DemiBold));
    m_value->setMinimumWidth(64);
    m_value->setAlignment(Qt::AlignRight);
    row->addWidget(m_slider, 1);
    row->addWidget(m_value);
    column->addLayout(row);
    // The first click on the slider counts even if it does not change the value: it sets the prediction to that many
    // points.
    const auto said = [this] {
        m_hasPoints = true;
        m_value->setText(QString::number(m_slider->sliderPosition()));
        showMissing();
    };
    connect(m_slider, &QSlider::sliderPressed, this, said);
    connect(m_slider, &QSlider::actionTriggered, this, said);
    connect(m_slider, &QSlider::valueChanged, this, said);

    auto* worst = new QLabel(block);
    text::bindTranslation(worst, [worst] { worst->setText(tr("What cost you most?")); });
    worst->setFont(typeface(kTitle, QFont::DemiBold));
    column->addWidget(worst);
    m_criteriaSlot = new QVBoxLayout;
    column->addLayout(m_criteriaSlot);

    m_missing = new QLabel(block);
    m_missing->setForegroundRole(QPalette::PlaceholderText);
    m_missing->setWordWrap(true);
    m_missing->setObjectName(QStringLiteral("missing"));
    m_show = new QPushButton(block);
    text::bindTranslation(m_show, [this] {
        m_show->setText(tr("Show the score"));
        m_show->setAccessibleName(m_show->text());
    });
    m_show->setProperty("kind", "filled");
    text::bindTranslation(m_show, [this] { m_show->setToolTip(tr("Show how your work was graded (Enter)")); });
    m_show->setAutoDefault(true);
    m_show->setObjectName(QStringLiteral("showScore"));
    column->addSpacing(kSpace2);
    column->addWidget(m_missing);
    column->addWidget(m_show, 0, Qt::AlignLeft);
    column->addStretch(2);
    connect(m_show, &QPushButton::clicked, this, [this] {
        const int chosen = m_worst->checkedId();
        emit answered({m_slider->value() * kTenthsAStep,
                       chosen < 0 ? std::string() : m_offered[static_cast<std::size_t>(chosen)].id});
    });
    body()->addWidget(new ScrollPane(content, QPalette::Window, this), 1);
    text::bindTranslation(this, [this] { retranslateUi(); });
}

void ScorePredictionPage::retranslateUi()
{
    setTitle(tr("Before you see the score"));
    m_slider->setAccessibleName(tr("How many points do you expect?"));
    if (m_worst == nullptr)
        return;
    //: %1 is a lesson, %2 the mark that is needed
    m_mark->setText(
        tr("%1. The pass mark is %2 of 100 points. You learn more from a score if you assess your own work first.")
            .arg(m_work, text::points(m_rubric.passMarkTenths)));
    for (std::size_t k = 0; k < m_offered.size(); ++k)
        m_worst->button(static_cast<int>(k))->setText(text::titleOf(m_offered[k]));
    showMissing();
}

void ScorePredictionPage::setWork(const QString& work)
{
    m_work = work;
    retranslateUi();
}

void ScorePredictionPage::ask(const QString& work, const ::lessons::Rubric& rubric)
{
    m_rubric = rubric;
    m_slider->setValue(kBeginAt);
    m_value->setText(QStringLiteral("–"));
    m_hasPoints = false;
    delete m_criteria;
    m_criteria = new QWidget(this);
    auto* column = new QVBoxLayout(m_criteria);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace1);
    m_offered = rubric.criteria;
    std::stable_sort(m_offered.begin(), m_offered.end(),
                     [](const auto& a, const auto& b) { return a.weightTenths > b.weightTenths; });
    m_offered.resize(std::min(kMostCriteria, m_offered.size()));
    m_worst = new QButtonGroup(m_criteria);
    for (int k = 0; k < static_cast<int>(m_offered.size()); ++k) {
        auto* button = new QRadioButton(m_criteria);
        m_worst->addButton(button, k);
        column->addWidget(button);
    }
    m_criteriaSlot->addWidget(m_criteria);
    // The answers were created after all other pages, so Tab would reach them last.
    QWidget* before = m_slider;
    for (QAbstractButton* answer : m_worst->buttons()) {
        setTabOrder(before, answer);
        before = answer;
    }
    setTabOrder(before, m_show);
    setWork(work);
}

void ScorePredictionPage::showMissing()
{
    m_show->setEnabled(m_hasPoints);
    m_missing->setText(m_hasPoints ? QString() : tr("Set the points that you expect."));
}

/// Lets Enter continue from anywhere on the page. An answer that only has the focus is chosen first.
void ScorePredictionPage::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) {
        Page::keyPressEvent(event);
        return;
    }
    for (QAbstractButton* answer : m_worst->buttons())
        if (answer->hasFocus() && !answer->isChecked()) {
            answer->click();
            return;
        }
    m_show->click();
}

void ScorePredictionPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    m_slider->setFocus();
}

}  // namespace ui::scoring
