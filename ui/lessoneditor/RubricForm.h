// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QWidget>

#include "lessons/LessonReader.h"

class QCheckBox;
class QDoubleSpinBox;
class QJsonObject;
class QLabel;
class QVBoxLayout;

namespace ui::lessoneditor {

/// The part of the lesson editor's form that is about the marking: what each criterion tolerates and weighs, and from
/// where on one has passed.
class RubricForm final : public QWidget
{
    Q_OBJECT
public:
    explicit RubricForm(QWidget* parent);

    /// Inputs for these criteria. They are made anew only where they are others than before.
    void offerCriteria(const std::vector<::lessons::CriterionRule>& criteria);
    /// All that it offers was named in another language: it is to be offered again.
    void forgetWords();
    /// @param rubric  the object of a file; it need not be one that could mark
    void showValues(const QJsonObject& rubric);
    /// Shows what is wrong with the marking beside what it is about, and answers the rest.
    [[nodiscard]] std::vector<::lessons::ValidationIssue>
    takeFaults(const std::vector<::lessons::ValidationIssue>& faults);

    /// Figures behind the point of a tolerance in this unit.
    [[nodiscard]] static int decimalsOf(const std::string& unit);

signals:
    /// @param key  "tolerance", "weight", "target" or "span", of the criterion of this number
    void criterionSet(int index, const char* key, double value);
    void passMarkSet(double points);

private:
    struct Criterion
    {
        std::string id;
        QLabel* name = nullptr;
        QDoubleSpinBox* tolerance = nullptr;
        QDoubleSpinBox* weight = nullptr;  ///< null for a critical one
        QDoubleSpinBox* target = nullptr;
        QDoubleSpinBox* span = nullptr;  ///< null for a critical one
        QWidget* more = nullptr;         ///< the row of target and span
        QLabel* fault = nullptr;

        void call(const QString& title) const;
    };

    [[nodiscard]] bool offers(const std::vector<::lessons::CriterionRule>& criteria) const;
    [[nodiscard]] QWidget* makeMore(const ::lessons::CriterionRule& rule, Criterion& inputs);
    void connectInput(QDoubleSpinBox* input, int index, const char* key);
    void showMore();
    void sumUp();

    QVBoxLayout* m_slot = nullptr;
    QWidget* m_inputs = nullptr;
    std::vector<Criterion> m_criteria;
    QCheckBox* m_more = nullptr;  ///< targets and spans are shown
    QLabel* m_sum = nullptr;
    QDoubleSpinBox* m_passMark = nullptr;
    bool m_isFilling = false;
};

}  // namespace ui::lessoneditor
