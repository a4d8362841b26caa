# Fig. 21: t-SNE of the output layer, before the softmax.
# height: words(words_method) < 5 ? 760 : 113 + 225 * panels(words(words_method), 5)
heading = "Test windows as the classifier's output layer sees them (t-SNE)"
load scripts.'/tsne.gp'
