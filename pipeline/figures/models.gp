# Names the models shown, for a title: some runs lack models of the paper's outlook. Loaded by scripts that show the
# paper's models.
models = "the paper's models"
do for [method in "piae-dt-tcn piae-dt-transformer"] {
  if (place(method, words_method)) { models = "the paper's models and those of its outlook" }
}
