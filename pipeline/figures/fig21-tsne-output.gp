# Fig. 21: t-SNE of the output layer, before the softmax.
# height: 760
heading = "Test windows as the classifier's output layer sees them (t-SNE)"
load scripts.'/tsne.gp'
