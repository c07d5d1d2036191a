// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessoneditor/RubricForm.h"

#include <cmath>
#include <map>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonObject>
#include <QLabel>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/Texts.h"
#include "ui/text/ValidationTexts.h"

namespace ui::lessoneditor {

using namespace ui::kit;

namespace {

double stepOf(const std::string& unit)
{
    return unit == "mm" ? 0.05 : unit == "mm2" || unit == "mm3" ? 0.1 : 1.0;
}

}  // namespace

int RubricForm::decimalsOf(const std::string& unit)
{
    return unit == "mm" || unit == "mm2" || unit == "mm3" ? 2 : 1;
}

RubricForm::RubricForm(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    auto* head = new QHBoxLayout;
    auto* title = kit::formWords({}, kBody, QFont::DemiBold, QPalette::WindowText, this);
    head->addWidget(title, 1);
    m_more = new QCheckBox(this);
    text::bindTranslation(m_more, [this] { m_more->setText(tr("Targets and spans")); });
    m_more->setObjectName(QStringLiteral("targetsAndSpans"));
    text::bindTranslation(m_more, [this] {
        m_more->setToolTip(
            brokenIntoLines(tr("What each measure ought to be, and how far beyond the tolerance all points are lost")));
    });
    connect(m_more, &QCheckBox::toggled, this, &RubricForm::showMore);
    head->addWidget(m_more);
    column->addLayout(head);
    m_slot = new QVBoxLayout;
    column->addLayout(m_slot);
    m_sum = kit::formWords({}, kBody, QFont::Medium, QPalette::WindowText, this);
    column->addWidget(m_sum);
    auto* pass = new QHBoxLayout;
    auto* passedFrom = kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this);
    pass->addWidget(passedFrom, 1);
    m_passMark = kit::numberInput(0.0, 100.0, 1, {}, {}, this);
    m_passMark->setFixedWidth(kit::kInputPx + kSpace4);
    connect(m_passMark, &QDoubleSpinBox::valueChanged, this, [this](double points) {
        if (!m_isFilling)
            emit passMarkSet(points);
    });
    pass->addWidget(m_passMark);
    column->addLayout(pass);
    text::bindTranslation(this, [this, title, passedFrom] {
        title->setText(tr("Marking"));
        passedFrom->setText(tr("Passed from"));
        m_passMark->setSuffix(QStringLiteral(" ") + tr("points"));
        m_passMark->setAccessibleName(tr("Pass mark"));
    });
}

bool RubricForm::offers(const std::vector<::lessons::CriterionRule>& criteria) const
{
    bool isSame = m_inputs != nullptr && m_criteria.size() == criteria.size();
    for (std::size_t k = 0; isSame && k < criteria.size(); ++k)
        isSame = m_criteria[k].id == criteria[k].id && (m_criteria[k].weight == nullptr) == criteria[k].critical;
    return isSame;
}

void RubricForm::forgetWords()
{
    delete m_inputs;
    m_inputs = nullptr;
    m_criteria.clear();
}

void RubricForm::offerCriteria(const std::vector<::lessons::CriterionRule>& criteria)
{
    if (offers(criteria)) {
        for (std::size_t k = 0; k < criteria.size(); ++k)
            m_criteria[k].call(text::titleOf(criteria[k]));  // the title may contain the criterion's limit
        return;
    }
    delete m_inputs;
    m_criteria.clear();
    m_inputs = new QWidget(this);
    auto* grid = new QGridLayout(m_inputs);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kSpace2);
    grid->setVerticalSpacing(kSpace1);
    grid->setColumnStretch(0, 1);
    const auto quiet = [this](const QString& text, int size) {
        return kit::formWords(text, size, QFont::Normal, QPalette::PlaceholderText, m_inputs);
    };
    grid->addWidget(quiet(tr("Tolerance"), kSmall), 0, 1);
    grid->addWidget(quiet(tr("Weight"), kSmall), 0, 2);
    int row = 1;
    for (const ::lessons::CriterionRule& rule : criteria) {
        const int index = static_cast<int>(m_criteria.size());
        auto* label = kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, m_inputs);
        grid->addWidget(label, row, 0);
        const auto add = [&](QDoubleSpinBox* input, const char* key, int column) {
            grid->addWidget(input, row, column);
            connectInput(input, index, key);
            return input;
        };
        Criterion inputs;
        inputs.id = rule.id;
        inputs.name = label;
        inputs.tolerance =
            add(kit::numberInput(0.0, 1000.0, decimalsOf(rule.unit), text::unitName(rule.unit), {}, m_inputs),
                "tolerance", 1);
        inputs.tolerance->setSingleStep(stepOf(rule.unit));
        inputs.tolerance->setObjectName(QStringLiteral("tolerance.") + QString::fromStdString(rule.id));
        inputs.tolerance->setFixedWidth(kit::kInputPx - kSpace2);
        if (rule.critical) {
            //: %1: the points that an error leaves at most
            grid->addWidget(
                quiet(rule.capTenths > 0 ? tr("at most %1").arg(text::points(rule.capTenths)) : tr("fails"), kBody),
                row, 2);
        } else {
            inputs.weight = add(kit::numberInput(0.1, 100.0, 1, {}, {}, m_inputs), "weight", 2);
            inputs.weight->setFixedWidth(kit::kInputPx - kSpace6);
        }
        inputs.more = makeMore(rule, inputs);
        connectInput(inputs.target, index, "target");
        if (inputs.span != nullptr)
            connectInput(inputs.span, index, "span");
        grid->addWidget(inputs.more, ++row, 0, 1, 3);
        inputs.fault = kit::faultLabel(m_inputs);
        grid->addWidget(inputs.fault, ++row, 0, 1, 3);
        inputs.call(text::titleOf(rule));
        m_criteria.push_back(inputs);
        ++row;
    }
    m_slot->addWidget(m_inputs);
    showMore();
}

/// Sets the visible title, and the names of the inputs for screen readers.
void RubricForm::Criterion::call(const QString& title) const
{
    name->setText(title);
    //: %1: a criterion
    tolerance->setAccessibleName(tr("Tolerance of: %1").arg(title));
    if (weight != nullptr)
        weight->setAccessibleName(tr("Weight of: %1").arg(title));
    target->setAccessibleName(tr("Target of: %1").arg(title));
    if (span != nullptr)
        span->setAccessibleName(tr("Span of: %1").arg(title));
}

void RubricForm::connectInput(QDoubleSpinBox* input, int index, const char* key)
{
    connect(input, &QDoubleSpinBox::valueChanged, this, [this, index, key](double value) {
        if (!m_isFilling)
            emit criterionSet(index, key, value);
    });
}

/// Makes the inputs for the target of a measure and for the range over which points decrease.
QWidget* RubricForm::makeMore(const ::lessons::CriterionRule& rule, Criterion& inputs)
{
    auto* more = new QWidget(m_inputs);
    auto* row = new QHBoxLayout(more);
    row->setContentsMargins(kSpace4, 0, 0, kSpace2);
    row->setSpacing(kSpace2);
    const auto add = [&](const QString& label, double low, const char* key) {
        row->addWidget(kit::formWords(label, kSmall, QFont::Normal, QPalette::PlaceholderText, more));
        auto* input = kit::numberInput(low, 10000.0, decimalsOf(rule.unit), text::unitName(rule.unit), {}, more);
        input->setSingleStep(stepOf(rule.unit));
        input->setFixedWidth(kit::kInputPx - kSpace2);
        input->setObjectName(QLatin1String(key) + u'.' + QString::fromStdString(rule.id));
        row->addWidget(input);
        return input;
    };
    //: What a measure ought to be
    inputs.target = add(tr("Target"), -10000.0, "target");
    if (!rule.critical)
        //: How far beyond the tolerance all points of a criterion are lost
        inputs.span = add(tr("all lost over"), 0.0, "span");
    row->addStretch(1);
    return more;
}

void RubricForm::showMore()
{
    for (const Criterion& inputs : m_criteria)
        inputs.more->setVisible(m_more->isChecked());
}

void RubricForm::showValues(const QJsonObject& rubric)
{
    const QScopedValueRollback filling(m_isFilling, true);
    const QJsonArray criteria = rubric.value(QStringLiteral("criteria")).toArray();
    for (std::size_t k = 0; k < m_criteria.size(); ++k) {
        const QJsonObject criterion = criteria.at(static_cast<qsizetype>(k)).toObject();
        kit::showNumber(*m_criteria[k].tolerance, criterion.value(QStringLiteral("tolerance")).toDouble());
        if (m_criteria[k].weight != nullptr)
            kit::showNumber(*m_criteria[k].weight, criterion.value(QStringLiteral("weight")).toDouble());
        kit::showNumber(*m_criteria[k].target, criterion.value(QStringLiteral("target")).toDouble());
        if (m_criteria[k].span != nullptr)
            kit::showNumber(*m_criteria[k].span, criterion.value(QStringLiteral("span")).toDouble());
    }
    kit::showNumber(*m_passMark, rubric.value(QStringLiteral("pass_mark")).toDouble());
}

std::vector<::lessons::ValidationIssue> RubricForm::takeFaults(const std::vector<::lessons::ValidationIssue>& faults)
{
    sumUp();
    std::vector<::lessons::ValidationIssue> others;
    std::map<QLabel*, QString> said;
    for (const Criterion& inputs : m_criteria)
        said[inputs.fault] = {};
    for (const ::lessons::ValidationIssue& fault : faults) {
        // The sum beside the weights shows this error.
        if (fault.key == u"rubric" && fault.english().contains(u"weight"))
            continue;
        QLabel* place = nullptr;
        for (std::size_t k = 0; k < m_criteria.size(); ++k)
            if (fault.key.startsWith(QStringLiteral("rubric.criteria[%1]").arg(k)))
                place = m_criteria[k].fault;
        if (place == nullptr) {
            others.push_back(fault);
            continue;
        }
        QString& words = said[place];
        words += (words.isEmpty() ? QString() : QStringLiteral(" ")) + text::capitalised(text::faultWords(fault.what));
    }
    for (const auto& [label, what] : said)
        kit::showFault(label, what);
    return others;
}

/// Shows the sum of the weights. A rubric with a wrong sum is invalid.
void RubricForm::sumUp()
{
    double sum = 0.0;
    for (const Criterion& inputs : m_criteria)
        sum += inputs.weight != nullptr ? inputs.weight->value() : 0.0;
    const bool isWhole = std::abs(sum - 100.0) < 0.01;
    QPalette colours = palette();
    if (!isWhole)
        colours.setColor(QPalette::WindowText, tones(palette()).harmText);
    m_sum->setPalette(colours);
    m_sum->setText(isWhole ? tr("All weights: %1 points").arg(text::number(sum, 1))
                           : QStringLiteral("⚠ ") +
                                 tr("All weights: %1 points; they must make 100").arg(text::number(sum, 1)));
}

}  // namespace ui::lessoneditor
