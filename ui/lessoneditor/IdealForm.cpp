// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessoneditor/IdealForm.h"

#include <algorithm>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"
#include "ui/text/ValidationTexts.h"

namespace ui::lessoneditor {

using namespace ui::kit;

IdealForm::IdealForm(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    m_head = kit::formWords({}, kBody, QFont::DemiBold, QPalette::WindowText, this);
    column->addWidget(m_head);
    m_reference = kit::choiceInput({}, this);
    text::bindTranslation(m_reference, [this] { kit::nameInput(m_reference, tr("What the ideal is")); });
    m_reference->setObjectName(QStringLiteral("reference"));
    connect(m_reference, &QComboBox::activated, this,
            [this](int index) { emit referenceChosen(m_reference->itemData(index).toString()); });
    column->addWidget(m_reference);
    m_fromRecordings = new QPushButton(this);
    m_fromRecordings->setAutoDefault(true);
    text::bindTranslation(m_fromRecordings, [this] {
        m_fromRecordings->setText(tr("Take recordings as the reference …"));
        m_fromRecordings->setToolTip(tr("Choose one attempt, or several whose mean is to be cut"));
        m_fromRecordings->setAccessibleName(m_fromRecordings->text());
    });
    connect(m_fromRecordings, &QPushButton::clicked, this, &IdealForm::recordingsRequested);
    column->addWidget(m_fromRecordings, 0, Qt::AlignLeft);
    m_fault = kit::faultLabel(this);
    column->addWidget(m_fault);
    m_fieldsSlot = new QVBoxLayout;
    column->addLayout(m_fieldsSlot);
    begin(::lessons::Task::RemoveDecay);
}

void IdealForm::forgetWords()
{
    m_reference->clear();
    delete m_fields;
    m_fields = nullptr;
    m_inputs.clear();
    m_faults.clear();
}

void IdealForm::begin(::lessons::Task task)
{
    const bool hasIdeal = task == ::lessons::Task::CutIdeal;
    m_head->setText(task == ::lessons::Task::RemoveDecay ? tr("The ideal is the decay itself: nothing is to be set")
                    : ::lessons::isExercise(task)        ? tr("An exercise: nothing is to be cut")
                                                         : tr("Ideal preparation"));
    m_reference->setVisible(hasIdeal);
    m_fromRecordings->setVisible(hasIdeal);
    offerFields({});
}

void IdealForm::offerReferences(const QStringList& captured, const QString& present)
{
    QStringList names = captured;
    if (!present.isEmpty() && !names.contains(present))
        names.prepend(present);
    names.prepend({});
    bool isSame = m_reference->count() == names.size();
    for (int k = 0; isSame && k < m_reference->count(); ++k)
        isSame = m_reference->itemData(k).toString() == names[k];
    if (!isSame) {
        m_reference->clear();
        for (const QString& name : names)
            //: %1: the name of a file
            m_reference->addItem(name.isEmpty() ? tr("By rule") : tr("Captured: %1").arg(name), name);
    }
    m_reference->setCurrentIndex(static_cast<int>(names.indexOf(present)));
}

void IdealForm::offerFields(const std::vector<IdealField>& fields)
{
    const bool isSame =
        m_fields != nullptr && m_inputs.size() == fields.size() &&
        std::all_of(fields.begin(), fields.end(), [&](const IdealField& field) { return m_inputs.contains(field.id); });
    if (isSame)
        return;
    delete m_fields;
    m_inputs.clear();
    m_faults.clear();
    m_fields = new QWidget(this);
    auto* grid = new QGridLayout(m_fields);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kSpace2);
    grid->setVerticalSpacing(kSpace1);
    grid->setColumnStretch(0, 1);
    int row = 0;
    for (const IdealField& field : fields) {
        QWidget* input = makeInput(field);
        grid->addWidget(kit::formWords(field.name, kBody, QFont::Normal, QPalette::WindowText, m_fields), row, 0);
        grid->addWidget(input, row++, 1);
        auto* fault = kit::faultLabel(m_fields);
        grid->addWidget(fault, row++, 0, 1, 2);
        m_inputs[field.id] = input;
        m_faults[field.id] = fault;
    }
    m_fieldsSlot->addWidget(m_fields);
}

QWidget* IdealForm::makeInput(const IdealField& field)
{
    const auto set = [this, id = field.id](double value) {
        if (!m_isFilling)
            emit sizeSet(id, value);
    };
    const bool isChoice = field.whole && field.minimum == 0.0 && field.maximum == 1.0;
    if (isChoice) {
        auto* choice = kit::choiceInput(field.name, m_fields);
        choice->addItems({tr("no"), tr("yes")});
        choice->setFixedWidth(kit::kInputPx);
        choice->setObjectName(field.id);
        connect(choice, &QComboBox::activated, this, [set](int index) { set(index); });
        return choice;
    }
    auto* number =
        kit::numberInput(field.minimum, field.maximum, field.whole ? 0 : 2, field.unit, field.name, m_fields);
    number->setSingleStep(field.whole || field.unit == u"°" ? 1.0 : 0.05);
    //: %1 and %2: the least and the greatest number that can be set; %3: a unit
    number->setToolTip(tr("%1 to %2 %3")
                           .arg(QLocale().toString(field.minimum), QLocale().toString(field.maximum), field.unit)
                           .trimmed());
    number->setObjectName(field.id);
    connect(number, &QDoubleSpinBox::valueChanged, this, set);
    return number;
}

void IdealForm::showValues(const std::vector<IdealField>& fields)
{
    const QScopedValueRollback filling(m_isFilling, true);
    for (const IdealField& field : fields) {
        const auto found = m_inputs.find(field.id);
        if (found == m_inputs.end())
            continue;
        if (auto* choice = qobject_cast<QComboBox*>(found->second))
            choice->setCurrentIndex(field.value > 0.5 ? 1 : 0);
        else if (auto* number = qobject_cast<QDoubleSpinBox*>(found->second))
            kit::showNumber(*number, field.value);
    }
}

std::vector<::lessons::ValidationIssue> IdealForm::takeFaults(const std::vector<::lessons::ValidationIssue>& faults)
{
    std::vector<::lessons::ValidationIssue> others;
    std::map<QLabel*, QString> said{{m_fault, {}}};
    for (const auto& [id, label] : m_faults)
        said[label] = {};
    for (const ::lessons::ValidationIssue& fault : faults) {
        QLabel* place = fault.key.startsWith(u"ideal") || fault.key.startsWith(u"tooth") ? m_fault : nullptr;
        for (const auto& [id, beside] : m_faults)
            if (fault.key.endsWith(u'.' + id) || fault.english().contains(u'(' + id + u')'))
                place = beside;
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

void IdealForm::setCapturing(bool capturing)
{
    m_fromRecordings->setEnabled(!capturing);
}

}  // namespace ui::lessoneditor
