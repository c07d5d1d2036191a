// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/Forecast.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QVBoxLayout>

#include "ui/shell/ScrollPane.h"
#include "ui/shell/TabularLabel.h"
#include "ui/shell/Theme.h"
#include "ui/text/Texts.h"

namespace ui::study {
namespace {

using namespace ui::shell;

constexpr int kCardWidthPx = 620;
constexpr int kTenthsAStep = 10;
constexpr int kBeginAt = 50;

}  // namespace

Forecast::Forecast(const Actions& actions, QWidget* parent) : Page(actions, tr("Before you see the score"), parent)
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

    auto* question = new QLabel(tr("How many points do you expect?"), block);
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
    m_slider->setAccessibleName(question->text());
    m_slider->setObjectName(QStringLiteral("expected"));
    m_value = new TabularLabel(block);
    m_value->setFont(typeface(kFigure, QFont::DemiBold));
    m_value->setMinimumWidth(64);
    m_value->setAlignment(Qt::AlignRight);
    row->addWidget(m_slider, 1);
    row->addWidget(m_value);
    column->addLayout(row);
    // The first step says where it stands: who expects just that many points says so by a click.
    const auto said = [this] {
        m_hasPoints = true;
        m_value->setText(QString::number(m_slider->sliderPosition()));
        showMissing();
    };
    connect(m_slider, &QSlider::sliderPressed, this, said);
    connect(m_slider, &QSlider::actionTriggered, this, said);
    connect(m_slider, &QSlider::valueChanged, this, said);

    auto* worst = new QLabel(tr("What cost you most?"), block);
    worst->setFont(typeface(kTitle, QFont::DemiBold));
    column->addWidget(worst);
    m_criteriaSlot = new QVBoxLayout;
    column->addLayout(m_criteriaSlot);

    m_missing = new QLabel(block);
    m_missing->setForegroundRole(QPalette::PlaceholderText);
    m_missing->setWordWrap(true);
    m_missing->setObjectName(QStringLiteral("missing"));
    m_show = new QPushButton(tr("Show the score"), block);
    m_show->setProperty("kind", "filled");
    m_show->setAccessibleName(m_show->text());
    m_show->setToolTip(tr("See how the work was marked (Enter)"));
    m_show->setAutoDefault(true);
    m_show->setObjectName(QStringLiteral("showScore"));
    column->addSpacing(kSpace2);
    column->addWidget(m_missing);
    column->addWidget(m_show, 0, Qt::AlignLeft);
    column->addStretch(2);
    connect(m_show, &QPushButton::clicked, this, [this] {
        emit answered({m_slider->value() * kTenthsAStep,
                       m_worst->checkedButton()->property("criterion").toString().toStdString()});
    });
    body()->addWidget(new ScrollPane(content, QPalette::Window, this), 1);
}

void Forecast::ask(const QString& work, const ::lessons::Rubric& rubric)
{
    //: %1 is a lesson, %2 the mark that is needed
    m_mark->setText(
        tr("%1. You pass from %2 of 100 points. A score teaches more once you have judged your work yourself.")
            .arg(work, text::points(rubric.passMarkTenths)));
    m_slider->setValue(kBeginAt);
    m_value->setText(QStringLiteral("–"));
    m_hasPoints = false;
    delete m_criteria;
    m_criteria = new QWidget(this);
    auto* column = new QVBoxLayout(m_criteria);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace1);
    m_worst = new QButtonGroup(m_criteria);
    const auto offer = [&](const QString& words, const QString& id) {
        auto* button = new QRadioButton(words, m_criteria);
        button->setProperty("criterion", id);
        m_worst->addButton(button);
        column->addWidget(button);
        return button;
    };
    for (const ::lessons::CriterionRule& rule : rubric.criteria) {
        ::lessons::Criterion line;
        line.title = rule.title;
        line.measure = rule.measure;
        offer(text::criterionName(line), QString::fromStdString(rule.id));
    }
    offer(tr("Nothing in particular"), {});
    connect(m_worst, &QButtonGroup::buttonClicked, this, &Forecast::showMissing);
    m_criteriaSlot->addWidget(m_criteria);
    // They were made after all other pages, and Tab would come to them last.
    QWidget* before = m_slider;
    for (QAbstractButton* answer : m_worst->buttons()) {
        setTabOrder(before, answer);
        before = answer;
    }
    setTabOrder(before, m_show);
    showMissing();
}

void Forecast::showMissing()
{
    const bool hasWorst = m_worst != nullptr && m_worst->checkedButton() != nullptr;
    m_show->setEnabled(m_hasPoints && hasWorst);
    m_missing->setText(!m_hasPoints ? tr("Set the points that you expect.")
                       : !hasWorst  ? tr("Choose what cost you most.")
                                    : QString());
}

/// Enter goes on from wherever one is: an answer that is only looked at it chooses first.
void Forecast::keyPressEvent(QKeyEvent* event)
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

void Forecast::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    m_slider->setFocus();
}

}  // namespace ui::study
